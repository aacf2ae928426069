// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_plots.h"

#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "chart/plot_painting.h"
#include "core/base/text.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/plot_saver.h"
#include "report/page/report_plots.h"
#include "report/report_files.h"

namespace hogelscope {

ReportPlotView::ReportPlotView(const QString& name, const QString& help)
    : m_saver(new PlotSaver(this, tr("Report"), {640, 400},
                            [this](QPainter& painter, const QSizeF& size) {
                              paintPlot(painter, size, m_plot, printColours(), m_selected);
                            })) {
  setObjectName(name);
  setMinimumSize(160, 100);
  setToolTip(help);
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
    : m_data(report),
      m_means(new ReportPlotView("reportMeans", tr("A click on a point chooses its test"))),
      m_map(new ReportPlotView("reportMap", tr("A click on an eye chooses its state"))),
      m_kind(new QComboBox),
      m_view(new ReportPlotView("reportPlot", tr("A click on a point chooses its row"))) {
  m_kind->setObjectName("reportPlotKind");
  m_kind->addItems({tr("PSNR over leakage window"), tr("PSNR over the states"),
                    tr("PSNR over the viewing angle"), tr("Error over the panel's hogels"),
                    tr("Error over their directions")});
  m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_kind->setToolTip(tr("The errors on the panel are there when the report is finished"));
  auto* kinds = new QWidget;
  auto* column = new QVBoxLayout(kinds);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_kind);
  column->addWidget(m_view, 1);
  auto* below = new QSplitter;
  below->addWidget(m_map);
  below->addWidget(kinds);
  below->setSizes({280, 280});
  auto* parts = new QSplitter(Qt::Vertical);
  parts->addWidget(m_means);
  parts->addWidget(below);
  parts->addWidget(makePictures());
  parts->setSizes({300, 280, 220});
  parts->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(parts);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &ReportPlots::showKind);
  connect(m_means, &ReportPlotView::clicked, this, &ReportPlots::testClicked);
  connect(m_map, &ReportPlotView::clicked, this, &ReportPlots::rowClicked);
  connect(m_view, &ReportPlotView::clicked, this, &ReportPlots::rowClicked);
}

QWidget* ReportPlots::makePictures() {
  m_pictures = new QWidget;
  m_title = new QLabel;
  m_title->setObjectName("reportPicturesTitle");
  auto* compare = new QToolButton;
  compare->setObjectName("compareStateButton");
  compare->setText(tr("Compare in the view"));
  compare->setToolTip(tr("Compares the state of the chosen row with its test in the view"));
  compare->setIcon(icon("external"));
  compare->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(compare, &QToolButton::clicked, this, &ReportPlots::compareAsked);
  auto* head = new QHBoxLayout;
  head->addWidget(m_title, 1);
  head->addWidget(compare);
  auto* row = new QHBoxLayout;
  for (const auto& [name, help] :
       {std::pair("reportReference", tr("The reference")), std::pair("reportTest", tr("The test")),
        std::pair("reportDifference", tr("Their difference, amplified as on the page"))}) {
    m_images.push_back(new ReportPlotView(name, help));
    row->addWidget(m_images.back());
  }
  constexpr int least = 200;
  m_pictures->setMinimumHeight(scaled(least));
  auto* layout = new QVBoxLayout(m_pictures);
  layout->addLayout(head);
  layout->addLayout(row, 1);
  m_pictures->hide();
  return m_pictures;
}

void ReportPlots::showTest(std::size_t test, std::optional<std::size_t> state) {
  m_test = test;
  m_row = state ? std::optional(m_data.order().row(*state, test)) : std::nullopt;
  const bool hasRows = !m_data.rows.empty();
  m_means->setPlot(m_data.summaries.empty() ? Plot() : meanPlot(m_data.plotted, m_data.summaries));
  m_means->select(test);
  m_map->setPlot(hasRows ? eyeMap(m_data.rows, test, m_data.tests.size(), m_data.session.display)
                         : Plot());
  m_map->select(m_row);
  showKind();
  showPictures();
}

void ReportPlots::showKind() {
  const int kind = m_kind->currentIndex();
  m_view->setPicture({});
  m_view->select(m_row);
  if (m_data.rows.empty()) return m_view->setPlot({});
  if (kind == overHogels || kind == overDirections) return showPanel();
  if (kind == overWindow)
    return m_view->setPlot(
        windowPlot(m_data.rows, m_test, m_data.tests.size(), m_data.session.cameras));
  Plot plot = psnrPlot(m_data.rows, m_data.session.display, kind == overAngle);
  for (std::size_t k = 0; k < plot.series.size(); ++k) plot.series[k].name = m_data.plotted[k].name;
  m_view->setPlot(plot);
}

/// Shows the report's image of the panel for the test, once its files are complete.
void ReportPlots::showPanel() {
  m_view->setPlot({});
  if (m_data.summaries.empty()) return;
  const bool isOfHogels = m_kind->currentIndex() == overHogels;
  const char* name = isOfHogels ? "hogels.png" : "directions.png";
  QString most = tr("most");
  if (m_test < m_data.panels.size()) {
    const PanelErrorFigures& figures = m_data.panels[m_test];
    most = tr("MSE %1").arg(QString::fromStdString(
        rounded(isOfHogels ? figures.hogelScale : figures.directionScale, 1)));
  }
  m_view->setPicture(
      QPixmap(QString::fromStdString(panelFile(m_data.folder, m_test, name).string())), most);
}

/// Shows the pictures of the chosen state that the report's folder has, if there is room.
void ReportPlots::showPictures() {
  const bool isFinished = m_row && !m_data.summaries.empty();
  const auto files = isFinished ? picturesOf(m_data.folder, m_data.rows, m_data.order(), *m_row)
                                : std::vector<std::filesystem::path>();
  constexpr int least = 480;
  m_pictures->setVisible(!files.empty() && height() >= scaled(least));
  if (files.empty()) return;
  const ReportRow& row = m_data.rows[*m_row];
  m_title->setText(QString::fromStdString(row.state + "   " + rounded(m_data.psnr(*m_row), 2) +
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
