// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/measure_widget.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "chart/depth_bar.h"
#include "chart/depth_budget_chart.h"
#include "chart/map_painting.h"
#include "chart/plot_painting.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "gui/docks/design_numbers_widget.h"
#include "gui/docks/design_sliders.h"
#include "gui/docks/measure_run_widget.h"
#include "gui/docks/painted_plot.h"
#include "gui/docks/sweep_widget.h"
#include "gui/session/session_forms.h"
#include "gui/widgets/column_area.h"
#include "gui/widgets/task_widgets.h"
#include "measure/measure_page.h"

namespace hogelscope {

namespace {

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

}  // namespace

MeasureWidget::MeasureWidget(QWidget* parent)
    : QWidget(parent),
      m_task(new Task(this)),
      m_status(new QLabel),
      m_fit(new QPushButton(tr("&Move content inside"))),
      m_tints(new QCheckBox(tr("&Tint depths outside"))),
      m_limit(new QComboBox),
      m_area(new ColumnArea),
      m_controls(new QVBoxLayout),
      m_right(new QVBoxLayout) {
  constexpr int restTime = 400;  // ms
  m_rest.setSingleShot(true);
  m_rest.setInterval(restTime);
  auto* controls = new QWidget;
  controls->setLayout(m_controls);
  m_controls->setSpacing(scaled(12));
  m_area->setObjectName("measureControls");
  m_area->setWidget(controls);
  m_area->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(m_area);
  columns->addLayout(m_right, 1);
  connect(&m_rest, &QTimer::timeout, this, &MeasureWidget::simulate);
  connect(m_task, &Task::failed, this, &MeasureWidget::showStatus);
}

MeasureWidget::~MeasureWidget() {
  m_task->abandon();
}

void MeasureWidget::setModel(SessionModel* model) {
  m_model = model;
  m_sliders = new DesignSliders(model);
  m_sweep = new SweepWidget(model, [this] { return m_sliders->hold(); });
  m_numbers = new DesignNumbersWidget(model, DesignNumbersWidget::Form::strip);
  addControls();
  auto* grid = new QGridLayout;
  grid->setSpacing(scaled(4));
  addPlots(grid);
  m_right->addWidget(m_numbers);
  m_right->addLayout(grid, 1);
  onAnyChange(model, this, &MeasureWidget::follow);
}

void MeasureWidget::addControls() {
  m_status->setObjectName("measureStatus");
  m_status->setTextFormat(Qt::PlainText);
  m_status->setWordWrap(true);
  m_fit->setObjectName("fitContentButton");
  m_fit->setEnabled(false);
  m_tints->setObjectName("tintBox");
  m_tints->setToolTip(
      tr("Tints the simulated view where content is outside these depths: blue behind them, red in "
         "front of them"));
  m_limit->setObjectName("limitBox");
  m_limit->addItems({tr("sharp on the display"), tr("comfortable for two eyes"), tr("both")});
  m_limit->setToolTip(
      tr("Which depths: where the display is sharp, where two eyes are comfortable, "
         "or where both are"));
  const auto heading = [](const QString& text) {
    auto* label = new QLabel(text);
    label->setFont(textFont(TextSize::base, QFont::DemiBold));
    return label;
  };
  for (QWidget* widget :
       std::initializer_list<QWidget*>{m_sliders, m_tints, m_limit, m_fit, m_status,
                                       new PolledBar(m_task), heading(tr("Sweep")), m_sweep,
                                       heading(tr("All figures")), new MeasureRunWidget(m_model)})
    m_controls->addWidget(widget);
  m_controls->addStretch(1);
  m_fit->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(m_fit, &QPushButton::clicked, this, &MeasureWidget::fit);
  connect(m_tints, &QCheckBox::toggled, this, &MeasureWidget::showTint);
  connect(m_limit, &QComboBox::currentIndexChanged, this, [this] {
    showTint();
    showFit();
  });
  connect(m_sliders, &DesignSliders::comparisonAsked, this, &MeasureWidget::comparisonAsked);
}

void MeasureWidget::addPlots(QGridLayout* grid) {
  const auto add = [grid](int row, int column, auto... parts) {
    auto* plot = new PaintedPlot(parts...);
    grid->addWidget(plot, row, column);
    return plot;
  };
  add(0, 0, "contrastPlot", tr("Contrast over depth and detail"),
      tr("Gratings on planes, as this eye sees them: bright is sharp; lines of contrast 0.5 and "
         "0.1"),
      [this](QPainter& painter, const QSizeF& size, const ChartColours& colours) {
        paintMap(painter, size, m_shown.contrast, colours);
      });
  add(0, 1, "zonePlot", tr("Viewing zone from above"),
      tr("The share of the panel that sends light to each place; the line is 0.95"),
      [this](QPainter& painter, const QSizeF& size, const ChartColours& colours) {
        paintMap(painter, size, m_shown.zone, colours);
      });
  add(1, 0, "depthsPlot", tr("Depth of the content"),
      tr("The pixels of this eye's view over depth; green is what the display shows sharply and is "
         "comfortable for two eyes"),
      [this](QPainter& painter, const QSizeF& size, const ChartColours& colours) {
        if (m_shown.depths)
          paintDepths(painter, QRectF({12, 0}, size - QSizeF(24, 4)),
                      {*m_shown.depths, depthBars(*m_shown.depths, m_shown.end)}, colours);
      });
  auto* swept = add(
      1, 1, "sweepPlot", tr("Sweep"),
      tr("A figure of the designs that were swept; a click on a point gives the session its value"),
      [this](QPainter& painter, const QSizeF& size, const ChartColours& colours) {
        const Plot plot = m_sweep->plot();
        if (!plot.series.empty())
          return paintPlot(painter, size, plot, colours, m_sweep->hovered());
        painter.setPen(colours.text2);
        painter.drawText(
            QRectF({}, size).adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap,
            plot.titleUp.empty() ? tr("Nothing is swept yet. Sweep shows how a figure follows one "
                                      "quantity of the design.")
                                 : tr("No design that was swept has a value of this figure."));
      });
  const auto pointAt = [this](const QPointF& place, const QSizeF& size) {
    return rowAt(m_sweep->plot(), place, size, chartFont().pixelSize());
  };
  swept->setMouse({[this, swept, pointAt](std::optional<QPointF> place, const QSizeF& size) {
                     const auto row = place ? pointAt(*place, size) : std::nullopt;
                     m_sweep->hover(row);
                     swept->setCursor(row ? Qt::PointingHandCursor : Qt::ArrowCursor);
                   },
                   [this, pointAt](const QPointF& place, const QSizeF& size) {
                     if (const auto row = pointAt(place, size)) m_sweep->apply(*row);
                   }});
  connect(m_sweep, &SweepWidget::plotChanged, swept, qOverload<>(&QWidget::update));
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 2);
  grid->setRowStretch(0, 1);
  grid->setRowStretch(1, 1);
}

void MeasureWidget::setSource(const std::optional<ViewSource>& source) {
  m_source = source;
  m_numbers->setSource(source);
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
  m_shown.pixels = {};
  showTint();
}

/// The session with its current state alone.
Session MeasureWidget::ofCurrent() const {
  Session session = m_model->session();
  session.cameras = {m_model->current()};
  return session;
}

/// The display with the light field's counts, of a lens sheet the number of views; none while it
/// lacks them.
std::optional<PanelParams> MeasureWidget::display() const {
  const Session& session = m_model->session();
  if (session.display.sheet && viewsOnSheet(session) < 2) return std::nullopt;
  if (session.display.sheet) return displayToMeasure(session, {});
  const PanelParams display = withCounts(
      displayOf(m_model->session()), m_source ? DisplayParams(m_source->display) : DisplayParams());
  if (display.hogels[0] < 1 || display.directions[0] < 1) return std::nullopt;
  return display;
}

/// Nothing is worked out while nobody sees it.
void MeasureWidget::follow() {
  if (!isVisible() || m_model == nullptr || m_model->session().cameras.empty()) return;
  m_task->stop();
  m_shown.pixels = {};
  showTint();
  const bool hasHogels = !m_model->session().display.sheet;
  for (QWidget* const own : std::initializer_list<QWidget*>{m_sliders, m_tints, m_sweep})
    own->setEnabled(hasHogels);
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
    if (!hasDirections(m_model->session().display)) m_shown.depths.reset();
    showStatus(tr("By formulas; the simulation follows"));
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
    if (source && hasDirections(panel)) {
      ViewSource current = *source;
      current.display = panel;
      const StatesDepths depths = depthsOfStates(session, current, part(progress, 0, 0.3));
      m_task->queue([this, session, depths] {
        if (session == ofCurrent()) showDepths(depths);  // no edit since
      });
    }
    const auto figures = mapFigures(session, panel, true, part(progress, 0.3, 1));
    const Bench bench = benchOf(session, panel);
    return [this, session, contrast = mtfMap(bench, figures), zone = zoneMap(bench, figures),
            most = agreementOf(figures).most] {
      if (session != ofCurrent()) return;
      m_shown.contrast = contrast;
      m_shown.zone = zone;
      showStatus(tr("Simulated; contrast differs from its closed form by at most %1")
                     .arg(most, 0, 'g', 2));
      update();
    };
  });
}

void MeasureWidget::showDepths(const StatesDepths& depths) {
  m_shown.depths = depths.states.front();
  m_shown.pixels = depths.first;
  m_shown.size = {depths.picture.width, depths.picture.height};
  m_shown.end = barsEnd(*m_shown.depths, nullptr);
  showTint();
  showFit();
  update();
}

/// Works out where the content would lie within the chosen depths, and says how much of it does.
void MeasureWidget::showFit() {
  m_shown.proposal.reset();
  const auto panel = display();
  if (!m_shown.depths || !panel) return m_fit->setEnabled(false);
  DepthFigures figures = *m_shown.depths;
  figures.limits = figures.limits.only(DepthLimit(m_limit->currentIndex()));
  const double limit = figures.limits.both();
  const auto within = std::ranges::count_if(figures.dioptres, [limit](double dioptres) {
    return DepthLimits::isWithin(dioptres, limit);
  });
  const auto count = double(figures.dioptres.size());
  figures.inside = count > 0 ? double(within) / count : 0;
  std::string obstacle = "no depth of what this eye sees is known";
  if (count > 0) m_shown.proposal = proposedFit(ofCurrent(), *panel, figures, obstacle);
  const bool isFit =
      m_shown.proposal && m_shown.proposal->session.lightField == m_model->session().lightField;
  m_fit->setEnabled(m_shown.proposal && !isFit);
  m_fit->setText(tr("&Move content inside (%1 % now)").arg(int(std::lround(100 * figures.inside))));
  m_fit->setToolTip(m_shown.proposal
                        ? (isFit ? tr("The content fits already")
                                 : QString::fromStdString(placeText(*m_shown.proposal)))
                        : QString::fromStdString(obstacle));
}

void MeasureWidget::showTint() {
  const bool isTinted = m_tints->isChecked() && m_shown.depths && !m_shown.pixels.z.empty();
  Q_EMIT tintChanged(
      isTinted ? depthTint(m_shown.size, m_shown.pixels,
                           m_shown.depths->limits.only(DepthLimit(m_limit->currentIndex())))
               : QImage());
}

void MeasureWidget::fit() {
  if (!m_shown.proposal) return;
  const LightFieldParams proposed = m_shown.proposal->session.lightField;
  Session content = m_model->session();
  content.lightField = proposed;
  m_model->setContent(content);
}

}  // namespace hogelscope
