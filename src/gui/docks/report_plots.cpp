// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_plots.h"

#include <QMouseEvent>
#include <QPainter>
#include <utility>

#include "chart/plot_painting.h"
#include "core/base/text.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/plot_saver.h"
#include "report/page/report_plots.h"
#include "report/report_files.h"
#include "ui_report_plots.h"

namespace hogelscope {

ReportPlotView::ReportPlotView(QWidget* parent)
    : QWidget(parent),
      m_saver(new PlotSaver(this, tr("Report"), {640, 400},
                            [this](QPainter& painter, const QSizeF& size) {
                              paintPlot(painter, size, m_plot, printColours(), m_selected);
                            })) {
  setMinimumSize(160, 100);
}

void ReportPlotView::setPlot(Plot plot) {
  m_plot = std::move(plot);
  m_saver->setEnabled(!m_plot.series.empty());
  update();
}

void ReportPlotView::setPicture(const QPixmap& picture, const QString& most) {
  m_picture = picture;
  m_most = most;
  update();
}

void ReportPlotView::select(std::optional<std::size_t> row) {
  m_selected = row;
  update();
}

void ReportPlotView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(chartFont());
  ChartColours colours = chartColours();
  colours.accent = tokens().eye;
  painter.fillRect(rect(), colours.background);
  if (m_picture.isNull()) {
    if (!m_plot.series.empty()) paintPlot(painter, QSizeF(size()), m_plot, colours, m_selected);
    return;
  }
  const int right = m_most.isEmpty() ? 0 : scaled(96);
  const QRect area = rect().adjusted(0, 0, -right, 0);
  QRect place(QPoint(), m_picture.size().scaled(area.size(), Qt::KeepAspectRatio));
  place.moveCenter(area.center());  // hogels stay square
  painter.setRenderHint(QPainter::SmoothPixmapTransform, m_most.isEmpty());
  painter.drawPixmap(place, m_picture);
  if (right > 0)
    paintColourBar(painter, QRectF(width() - right + 8, 12, 8, height() - 24), "0", m_most,
                   colours.text2);
}

void ReportPlotView::mousePressEvent(QMouseEvent* event) {
  if (!m_picture.isNull() || event->button() != Qt::LeftButton) return;  // the right opens a menu
  const double text = chartFont().pixelSize();
  if (const auto row = rowAt(m_plot, event->position(), QSizeF(size()), text)) Q_EMIT clicked(*row);
}

ReportPlots::ReportPlots(const ReportData& report)
    : m_data(report), m_ui(std::make_unique<Ui::ReportPlots>()) {
  m_ui->setupUi(this);
  constexpr int least = 200;
  m_ui->pictures->setMinimumHeight(scaled(least));
  m_ui->plotsBelow->setSizes({280, 280});
  m_ui->plots->setSizes({300, 280, 220});
  m_ui->compareStateButton->setIcon(icon("external"));
  m_images = {m_ui->reportReference, m_ui->reportTest, m_ui->reportDifference};
  connect(m_ui->compareStateButton, &QToolButton::clicked, this, &ReportPlots::compareAsked);
  connect(m_ui->reportPlotKind, &QComboBox::currentIndexChanged, this, &ReportPlots::showKind);
  connect(m_ui->reportMeans, &ReportPlotView::clicked, this, &ReportPlots::testClicked);
  connect(m_ui->reportMap, &ReportPlotView::clicked, this, &ReportPlots::rowClicked);
  connect(m_ui->reportPlot, &ReportPlotView::clicked, this, &ReportPlots::rowClicked);
}

ReportPlots::~ReportPlots() = default;

void ReportPlots::showTest(std::size_t test, std::optional<std::size_t> state) {
  m_test = test;
  m_row = state ? std::optional(m_data.order().row(*state, test)) : std::nullopt;
  const bool hasRows = !m_data.rows.empty();
  m_ui->reportMeans->setPlot(m_data.summaries.empty() ? Plot()
                                                      : meanPlot(m_data.plotted, m_data.summaries));
  m_ui->reportMeans->select(test);
  m_ui->reportMap->setPlot(
      hasRows ? eyeMap(m_data.rows, test, m_data.tests.size(), m_data.session.display) : Plot());
  m_ui->reportMap->select(m_row);
  showKind();
  showPictures();
}

void ReportPlots::showKind() {
  const int kind = m_ui->reportPlotKind->currentIndex();
  m_ui->reportPlot->setPicture({});
  m_ui->reportPlot->select(m_row);
  if (m_data.rows.empty()) return m_ui->reportPlot->setPlot({});
  if (kind == overHogels || kind == overDirections) return showPanel();
  if (kind == overWindow)
    return m_ui->reportPlot->setPlot(
        windowPlot(m_data.rows, m_test, m_data.tests.size(), m_data.session.cameras));
  Plot plot = psnrPlot(m_data.rows, m_data.session.display, kind == overAngle);
  for (std::size_t k = 0; k < plot.series.size(); ++k) plot.series[k].name = m_data.plotted[k].name;
  m_ui->reportPlot->setPlot(plot);
}

/// Shows the report's image of the panel for the test, once its files are complete.
void ReportPlots::showPanel() {
  m_ui->reportPlot->setPlot({});
  if (m_data.summaries.empty()) return;
  const bool isOfHogels = m_ui->reportPlotKind->currentIndex() == overHogels;
  const char* name = isOfHogels ? "hogels.png" : "directions.png";
  QString most = tr("most");
  if (m_test < m_data.panels.size()) {
    const PanelErrorFigures& figures = m_data.panels[m_test];
    most = tr("MSE %1").arg(QString::fromStdString(
        rounded(isOfHogels ? figures.hogelScale : figures.directionScale, 1)));
  }
  m_ui->reportPlot->setPicture(
      QPixmap(QString::fromStdString(panelFile(m_data.folder, m_test, name).string())), most);
}

/// Shows the pictures of the chosen state that the report's folder has, if there is room.
void ReportPlots::showPictures() {
  const bool isFinished = m_row && !m_data.summaries.empty();
  const auto files = isFinished ? picturesOf(m_data.folder, m_data.rows, m_data.order(), *m_row)
                                : std::vector<std::filesystem::path>();
  constexpr int least = 480;
  m_ui->pictures->setVisible(!files.empty() && height() >= scaled(least));
  if (files.empty()) return;
  const ReportRow& row = m_data.rows[*m_row];
  m_ui->reportPicturesTitle->setText(
      QString::fromStdString(viewName(row) + "   " + rounded(m_data.psnr(*m_row), 2) +
                             " dB · SSIM " + rounded(row.values[ssimSeenColumn], 3)));
  for (std::size_t k = 0; k < m_images.size(); ++k) {
    m_images[k]->setVisible(k < files.size());
    if (k < files.size())
      m_images[k]->setPicture(QPixmap(QString::fromStdString(files[k].string())));
  }
}

void ReportPlots::resizeEvent(QResizeEvent*) {
  showPictures();
}

}  // namespace hogelscope
