// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/measure_widget.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <cmath>

#include "chart/depth_bar.h"
#include "chart/depth_budget_chart.h"
#include "chart/map_painting.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/plot_saver.h"
#include "gui/session/session_forms.h"
#include "gui/widgets/polled_bar.h"
#include "gui/widgets/task.h"
#include "measure/measure_page.h"

namespace hogelscope {

namespace {

/// A plot that a function paints, with a title and "Save plot…".
class PaintedPlot : public QWidget {
 public:
  PaintedPlot(const QString& title, Paint paint, Paint paintFile)
      : m_title(title), m_paint(std::move(paint)) {
    setMinimumSize(scaled(220), scaled(120));
    new PlotSaver(this, title, {720, 420}, std::move(paintFile));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(chartFont());
    painter.fillRect(rect(), chartColours().background);
    painter.setPen(chartColours().text);
    const double line = 1.6 * painter.fontMetrics().height();
    painter.drawText(QRectF(scaled(8), 0, width(), line), Qt::AlignVCenter, m_title);
    painter.translate(0, line);
    m_paint(painter, QSizeF(width(), height() - line));
  }

 private:
  QString m_title;
  Paint m_paint;
};

/// Returns the maps' figures in closed form, or as the engine has them.
std::vector<MeasuredFigure> mapFigures(const Session& session, const PanelParams& display,
                                       bool isSimulated, const Progress& progress) {
  Bench bench = benchOf(session, display);
  std::vector<MeasuredFigure> figures;
  for (Measurement& one : measurementsOf(session, bench))
    if (one.figure == "mtf" || one.where.starts_with("share"))
      figures.push_back({std::move(one), one.closedForm, ""});
  if (!isSimulated) return figures;
  std::vector<Bench> benches(std::size_t(threadCount()), bench);
  StepProgress steps(progress);
  steps.expect(double(figures.size()));
  sideBySide(figures.size(), threadCount(), [&](std::size_t k, std::size_t worker) {
    figures[k].value = figures[k].of.simulate(benches[worker]);
    steps.finish();
  });
  return figures;
}

double farthestFromForms(const std::vector<MeasuredFigure>& figures) {
  double most = 0;
  for (const MeasuredFigure& one : figures)
    if (one.of.figure == "mtf" && !std::isnan(one.difference()))
      most = std::max(most, std::abs(one.difference()));
  return most;
}

}  // namespace

MeasureWidget::MeasureWidget(QWidget* parent)
    : QWidget(parent),
      m_task(new Task(this)),
      m_progress(new PolledBar([this] { return m_task->share(); }, this)),
      m_status(new QLabel),
      m_fit(new QPushButton) {
  constexpr int restTime = 400;  // ms
  m_rest.setSingleShot(true);
  m_rest.setInterval(restTime);
  m_status->setObjectName("measureStatus");
  m_status->setTextFormat(Qt::PlainText);
  m_fit->setObjectName("fitContentButton");
  m_fit->setText(tr("&Fit the content"));
  m_fit->setEnabled(false);
  auto* grid = new QGridLayout(this);
  grid->addWidget(makePlot("contrastPlot", tr("Contrast over depth and detail"),
                           tr("Gratings on planes, as this eye sees them: bright is sharp; lines "
                              "of contrast 0.5 and 0.1")),
                  0, 0);
  grid->addWidget(makePlot("depthsPlot", tr("Depth of the content"),
                           tr("The pixels of this eye's view over depth; green is what the display "
                              "shows sharply and is comfortable for two eyes")),
                  1, 0);
  grid->addWidget(makePlot("zonePlot", tr("Viewing zone from above"),
                           tr("The share of the panel that sends light to each place; the line is "
                              "0.95")),
                  0, 1);
  auto* column = new QVBoxLayout;
  column->addWidget(m_fit);
  column->addWidget(m_status);
  column->addWidget(m_progress);
  column->addStretch(1);
  m_status->setWordWrap(true);
  grid->addLayout(column, 1, 1);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 2);
  grid->setRowStretch(0, 1);
  grid->setRowStretch(1, 1);
  m_progress->hide();
  connect(m_fit, &QPushButton::clicked, this, &MeasureWidget::fit);
  connect(&m_rest, &QTimer::timeout, this, &MeasureWidget::simulate);
  connect(m_task, &Task::stopped, m_progress, &QWidget::hide);
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    m_progress->hide();
    showStatus(line);
  });
}

MeasureWidget::~MeasureWidget() {
  m_task->abandon();
}

QWidget* MeasureWidget::makePlot(const char* name, const QString& title, const QString& tip) {
  const QString which = name;
  const auto paint = [this, which](QPainter& painter, const QSizeF& size,
                                   const ChartColours& colours) {
    if (which != "depthsPlot")
      return paintMap(painter, size, which == "zonePlot" ? m_shown.zone : m_shown.contrast,
                      colours);
    if (m_shown.depths)
      paintDepths(painter, QRectF({12, 0}, size - QSizeF(24, 4)),
                  {*m_shown.depths, depthBars(*m_shown.depths, m_shown.end)}, colours);
  };
  auto* plot = new PaintedPlot(
      title,
      [paint](QPainter& painter, const QSizeF& size) { paint(painter, size, chartColours()); },
      [paint](QPainter& painter, const QSizeF& size) { paint(painter, size, printColours()); });
  plot->setObjectName(name);
  plot->setToolTip(tip);
  plot->setAccessibleName(title);
  return plot;
}

void MeasureWidget::setModel(SessionModel* model) {
  m_model = model;
  onAnyChange(model, this, &MeasureWidget::follow);
}

void MeasureWidget::setSource(const std::optional<ViewSource>& source) {
  m_source = source;
  follow();
}

void MeasureWidget::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follow();
}

void MeasureWidget::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_rest.stop();
  m_task->stop();
}

/// The session with its current state alone.
Session MeasureWidget::ofCurrent() const {
  Session session = m_model->session();
  session.cameras = {m_model->current()};
  return session;
}

/// The display with the light field's counts; none while it lacks them.
std::optional<PanelParams> MeasureWidget::display() const {
  PanelParams display = displayOf(m_model->session());
  for (const auto counts : {&PanelParams::hogels, &PanelParams::directions})
    for (const std::size_t axis : {0, 1}) {
      int& count = (display.*counts)[axis];
      if (count < 1 && m_source) count = (m_source->display.*counts)[axis];
      if (count < 1) return std::nullopt;
    }
  return display;
}

/// Nothing is worked out while nobody sees it.
void MeasureWidget::follow() {
  if (!isVisible() || m_model == nullptr || m_model->session().cameras.empty()) return;
  m_task->stop();
  showClosedForms();
  m_rest.start();
}

void MeasureWidget::showStatus(const QString& text) {
  m_status->setText(text);
}

void MeasureWidget::showClosedForms() {
  m_shown.contrast = m_shown.zone = {};
  try {
    if (const auto panel = display()) {
      const auto figures = mapFigures(ofCurrent(), *panel, false, {});
      const Bench bench = benchOf(ofCurrent(), *panel);
      m_shown.contrast = mtfMap(bench, figures);
      m_shown.zone = zoneMap(bench, figures);
    }
    showStatus(tr("Closed forms"));
  } catch (const std::exception& error) {
    showStatus(QString::fromUtf8(error.what()));
  }
  m_fit->setEnabled(false);
  update();
}

void MeasureWidget::simulate() {
  const auto panel = display();
  if (!isVisible() || !panel) return;
  m_task->start([this, session = ofCurrent(), panel = *panel,
                 source = m_source](const Progress& progress) -> Task::Answer {
    if (source) {
      ViewSource current = *source;
      current.display = panel;
      const StatesDepths depths = depthsOfStates(session, current, part(progress, 0, 0.3));
      const DepthFigures& figures = depths.states.front();
      std::string obstacle = "no depth of what this eye sees is known";
      std::optional<DepthProposal> proposal;
      if (!figures.dioptres.empty()) proposal = proposedFit(session, panel, figures, obstacle);
      m_task->queue([this, session, figures, proposal, obstacle] {
        if (session == ofCurrent())  // no edit since
          showDepths(figures, proposal, QString::fromStdString(obstacle));
      });
    }
    const auto figures = mapFigures(session, panel, true, part(progress, 0.3, 1));
    const Bench bench = benchOf(session, panel);
    return [this, session, contrast = mtfMap(bench, figures), zone = zoneMap(bench, figures),
            most = farthestFromForms(figures)] {
      m_progress->hide();
      if (session != ofCurrent()) return;
      m_shown.contrast = contrast;
      m_shown.zone = zone;
      showStatus(tr("Simulated; contrast differs from its closed form by at most %1")
                     .arg(most, 0, 'g', 2));
      update();
    };
  });
  m_progress->show();
}

void MeasureWidget::showDepths(const DepthFigures& figures, std::optional<DepthProposal> proposal,
                               const QString& obstacle) {
  m_shown.depths = figures;
  m_shown.end = barsEnd(figures, nullptr);
  m_shown.proposal = std::move(proposal);
  const int inside = int(std::lround(100 * figures.inside));
  const bool isFit =
      m_shown.proposal && m_shown.proposal->session.lightField == m_model->session().lightField;
  m_fit->setEnabled(m_shown.proposal && !isFit);
  m_fit->setText(tr("&Fit the content (%1 % inside)").arg(inside));
  m_fit->setToolTip(m_shown.proposal
                        ? (isFit ? tr("The content fits already")
                                 : QString::fromStdString(placeText(*m_shown.proposal)))
                        : obstacle);
  update();
}

void MeasureWidget::fit() {
  if (!m_shown.proposal) return;
  const LightFieldParams proposed = m_shown.proposal->session.lightField;
  Session content = m_model->session();
  content.lightField = proposed;
  m_model->setContent(content);
}

}  // namespace hogelscope
