// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_results.h"

#include <QComboBox>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>
#include <limits>
#include <utility>

#include "chart/plot_painting.h"
#include "gui/docks/plot_saver.h"
#include "report/page/report_plots.h"
#include "report/report_files.h"

namespace hogelscope {

ReportTable::ReportTable(QObject* parent) : QAbstractTableModel(parent) {
  begin(0);
}

void ReportTable::begin(std::size_t rows, const MetricSet& metrics) {
  beginResetModel();
  m_metrics = metrics;
  m_columns.clear();
  for (std::size_t k = 0; k < m_metrics.columns().size(); ++k)
    if (m_metrics.columns()[k].where == MetricColumn::Where::window) m_columns.push_back(k);
  m_rows.assign(rows, std::nullopt);
  endResetModel();
}

void ReportTable::set(std::size_t index, const ReportRow& row) {
  if (index >= m_rows.size()) return;
  m_rows[index] = row;
  Q_EMIT headerDataChanged(Qt::Vertical, int(index), int(index));
  Q_EMIT dataChanged(this->index(int(index), 0), this->index(int(index), columnCount() - 1));
}

int ReportTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_rows.size());
}

int ReportTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : 1 + int(m_columns.size());
}

QString ReportTable::textOf(const ReportRow& row, int column) const {
  if (column == test) return QString::fromStdString(row.test);
  if (column == test + 1 && !row.problem.empty()) return QString::fromStdString(row.problem);
  return QString::fromStdString(tableText(metric(column), value(row, column)));
}

QVariant ReportTable::data(const QModelIndex& index, int role) const {
  const std::optional<ReportRow>& row = m_rows[std::size_t(index.row())];
  const bool isText = index.column() == test;
  if (role == Qt::TextAlignmentRole && !isText) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (!row) return {};
  if (role == Qt::ToolTipRole) return QString::fromStdString(row->problem);
  if (role == Qt::DisplayRole || (role == sortRole && isText)) return textOf(*row, index.column());
  if (role != sortRole) return {};
  const double number = value(*row, index.column());
  return std::isnan(number) ? -std::numeric_limits<double>::infinity() : number;  // problems first
}

QVariant ReportTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return rowHeader(section, role);
  if (section < 0 || section >= columnCount()) return {};
  if (section == test) {
    if (role == Qt::DisplayRole) return tr("Test");
    if (role == Qt::ToolTipRole) return tr("The test light field");
    return {};
  }
  const MetricColumn& column = metric(section);
  const std::string unit = column.unit.empty() ? "" : ", " + column.unit;
  if (role == Qt::DisplayRole) return QString::fromStdString(column.title + unit);
  if (role == Qt::ToolTipRole) return QString::fromStdString(column.help);
  return {};
}

QVariant ReportTable::rowHeader(int section, int role) const {
  if (section < 0 || section >= rowCount() || !m_rows[std::size_t(section)]) return {};
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  return QString::fromStdString(m_rows[std::size_t(section)]->state);
}

ReportPlotView::ReportPlotView(QWidget* parent)
    : QWidget(parent),
      m_saver(new PlotSaver(this, tr("Report"), {640, 400},
                            [this](QPainter& painter, const QSizeF& size) {
                              paintPlot(painter, size, m_plot, m_selected);
                            })) {
  setObjectName("reportPlot");
  setMinimumSize(200, 120);
  setToolTip(tr("A click on a point chooses its row"));
}

void ReportPlotView::setPlot(Plot plot) {
  m_plot = std::move(plot);
  m_saver->setEnabled(!m_plot.series.empty());
  update();
}

void ReportPlotView::setPicture(const QPixmap& picture) {
  m_picture = picture;
  update();
}

void ReportPlotView::select(std::optional<std::size_t> row) {
  m_selected = row;
  update();
}

void ReportPlotView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  if (!m_picture.isNull()) {  // hogels stay square
    QRect place(QPoint(), m_picture.size().scaled(size(), Qt::KeepAspectRatio));
    place.moveCenter(rect().center());
    return painter.drawPixmap(place, m_picture);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (!m_plot.series.empty()) paintPlot(painter, QSizeF(size()), m_plot, m_selected);
}

void ReportPlotView::mousePressEvent(QMouseEvent* event) {
  if (!m_picture.isNull() || event->button() != Qt::LeftButton) return;  // the right opens a menu
  if (const auto row = rowAt(m_plot, event->position(), QSizeF(size()))) Q_EMIT clicked(*row);
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
  m_rows.clear();
  for (const CameraState& state : request.session.cameras)
    for (const std::string& test : tests)
      m_rows.push_back({state.camera.name, test, {}, state.camera.eye, 1, "not compared yet"});
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
  m_view->setPlot(isOfPanel() ? Plot()
                              : psnrPlot(m_rows, m_request.session.display,
                                         m_kind->currentIndex() == overAngle));
  m_view->select(m_selected);
}

bool ReportPlots::isOfPanel() const {
  return m_kind->currentIndex() == overHogels || m_kind->currentIndex() == overDirections;
}

/// Returns the report's panel image for the chosen row's test; null before the report is finished.
QPixmap ReportPlots::panel() const {
  if (!m_isFinished || m_tests.empty()) return {};
  const std::size_t test = m_selected ? ReportOrder{m_tests.size()}.test(*m_selected) : 0;
  const char* name = m_kind->currentIndex() == overHogels ? "hogels.png" : "directions.png";
  return QPixmap(QString::fromStdString(panelFile(m_request.output, test, name).string()));
}

}  // namespace hogelscope
