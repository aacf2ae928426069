// SPDX-License-Identifier: BSD-3-Clause
// The report dock's plots.
#include "gui/docks/report_plots.h"

#include <QComboBox>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>
#include <utility>

#include "report/report_files.h"

namespace hogelscope {

ReportPlotView::ReportPlotView(QWidget* parent) : QWidget(parent) {
  setObjectName("reportPlot");
  setMinimumSize(200, 120);
  setToolTip(tr("A click on a point chooses its row"));
}

void ReportPlotView::setChart(ReportChart chart) {
  m_chart = std::move(chart);
  update();
}

void ReportPlotView::setPicture(const QPixmap& picture) {
  m_picture = picture;
  update();
}

void ReportPlotView::select(std::optional<std::size_t> row) {
  m_chart.select(row);
  update();
}

void ReportPlotView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  if (!m_picture.isNull()) {  // each hogel stays a square
    QRect place(QPoint(), m_picture.size().scaled(size(), Qt::KeepAspectRatio));
    place.moveCenter(rect().center());
    return painter.drawPixmap(place, m_picture);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (!m_chart.isEmpty()) m_chart.paint(painter, QSizeF(size()));
}

void ReportPlotView::mousePressEvent(QMouseEvent* event) {
  if (!m_picture.isNull()) return;
  if (const auto row = m_chart.rowAt(event->position(), QSizeF(size()))) Q_EMIT clicked(*row);
}

ReportPlots::ReportPlots(QWidget* parent)
    : QWidget(parent), m_kind(new QComboBox), m_view(new ReportPlotView) {
  m_kind->setObjectName("reportPlotKind");
  m_kind->addItems({tr("PSNR over the states"), tr("PSNR over the viewing angle"),
                    tr("Error over the panel's hogels"), tr("Error over their directions")});
  m_kind->setToolTip(tr("The errors on the panel are there when the report is finished"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_kind);
  layout->addWidget(m_view, 1);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &ReportPlots::showPlot);
  connect(m_view, &ReportPlotView::clicked, this, &ReportPlots::clicked);
}

void ReportPlots::begin(const ReportRequest& request, const std::vector<std::string>& tests) {
  m_request = request;
  m_tests = tests;
  m_rows.assign(request.session.cameras.size() * tests.size(), std::nullopt);
  m_selected.reset();
  m_isFinished = false;
  showPlot();
}

void ReportPlots::set(std::size_t index, const ReportRow& row) {
  if (index >= m_rows.size()) return;
  m_rows[index] = row;
  showPlot();
}

void ReportPlots::finish() {
  m_isFinished = true;
  showPlot();
}

void ReportPlots::select(std::optional<std::size_t> row) {
  m_selected = row;
  isOfPanel() ? showPlot() : m_view->select(row);
}

void ReportPlots::showPlot() {
  m_view->setPicture(isOfPanel() ? panel() : QPixmap());
  m_view->setChart(isOfPanel() ? ReportChart() : chart());
  m_view->select(m_selected);
}

bool ReportPlots::isOfPanel() const {
  return m_kind->currentIndex() == overHogels || m_kind->currentIndex() == overDirections;
}

ReportChart ReportPlots::chart() const {
  const DisplayParams& display = m_request.session.display;
  const RigidTransform displayFromWorld =
      transformFromPose(display.position, display.orientation).inverse();
  const ReportOrder order{m_tests.size()};
  const bool isOverAngle = m_kind->currentIndex() == overAngle;
  std::vector<ReportChart::Point> points;
  for (std::size_t k = 0; k < m_rows.size(); ++k) {
    if (!m_rows[k] || !m_rows[k]->problem.empty()) continue;
    const Vec3 eye = displayFromWorld.point(m_rows[k]->eye);
    const double angle = std::atan2(eye.x, eye.z) * 180 / std::numbers::pi;
    points.push_back({k, order.test(k), isOverAngle ? angle : double(order.state(k) + 1),
                      m_rows[k]->values[psnrSeenColumn]});
  }
  std::vector<QString> series;
  for (const std::string& test : m_tests) series.push_back(QString::fromStdString(test));
  return {std::move(points),
          isOverAngle ? tr("horizontal viewing angle, °, to the viewer's right") : tr("state"),
          std::move(series)};
}

/// Of the chosen row's test, as the report's own file has it.
QPixmap ReportPlots::panel() const {
  if (!m_isFinished || m_tests.empty()) return {};
  const std::size_t test = m_selected ? ReportOrder{m_tests.size()}.test(*m_selected) : 0;
  const char* name = m_kind->currentIndex() == overHogels ? "hogels.png" : "directions.png";
  return QPixmap(QString::fromStdString(panelFile(m_request.output, test, name).string()));
}

}  // namespace hogelscope
