// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/sweep_widget.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "gui/session/session_forms.h"
#include "gui/widgets/task_widgets.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr std::size_t mostValues = 12;  // of a sweep

/// Returns the figures that a sweep measures; the last one needs a live scene.
std::vector<FigureRow> sweptFigures() {
  std::vector<FigureRow> figures;
  std::ranges::copy_if(figureRows(), std::back_inserter(figures), &FigureRow::inWindow);
  std::ranges::sort(figures, {}, &FigureRow::inWindow);
  return figures;
}

/// Returns the values of a sweep, evenly spaced as the parameter's slider is.
std::vector<double> valuesOf(const DesignParameter& parameter, double from, double to) {
  const double first = parameter.shareOf(from);
  const double last = parameter.shareOf(to);
  std::vector<double> values;
  for (std::size_t k = 0; k < mostValues; ++k)
    values.push_back(parameter.at(first + (last - first) * double(k) / (mostValues - 1)));
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
  return values;
}

}  // namespace

SweepWidget::SweepWidget(SessionModel* model, std::function<Hold()> hold, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_hold(std::move(hold)),
      m_task(new Task(this)),
      m_parameter(new QComboBox),
      m_figure(new QComboBox),
      m_from(new RealField(this)),
      m_to(new RealField(this)),
      m_note(new QLabel) {
  m_parameter->setObjectName("sweepParameter");
  m_figure->setObjectName("sweepFigure");
  m_from->setObjectName("sweepFrom");
  m_to->setObjectName("sweepTo");
  m_note->setObjectName("sweepNote");
  m_note->setWordWrap(true);
  m_note->setTextFormat(Qt::PlainText);
  m_note->hide();
  for (const DesignParameter& one : designParameters()) m_parameter->addItem(one.label);
  m_parameter->setCurrentIndex(1);
  for (const FigureRow& one : sweptFigures()) {
    const QString unit = QString::fromUtf8(one.unit.data(), qsizetype(one.unit.size()));
    m_figure->addItem(unit.isEmpty() ? tr(one.title) : tr(one.title) + ", " + unit);
  }
  for (QComboBox* box : {m_parameter, m_figure})
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* sweepButton = button<TaskButton>(
      "sweepButton", tr("S&weep"),
      tr("Measures designs whose chosen quantity has up to 12 values in the range, "
         "for the current eye"));
  sweepButton->control(m_task, [this] { sweep(); });
  auto* ends = new QHBoxLayout;
  ends->addWidget(m_from);
  ends->addWidget(m_to);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Parameter"), m_parameter);
  form->addRow(tr("Range"), ends);
  form->addRow(sweepButton);
  form->addRow(new PolledBar(m_task, this));
  form->addRow(tr("Figure"), m_figure);
  form->addRow(m_note);
  connect(m_parameter, &QComboBox::currentIndexChanged, this, &SweepWidget::propose);
  connect(m_figure, &QComboBox::currentIndexChanged, this, &SweepWidget::plotChanged);
  connect(m_model, &SessionModel::opened, this, &SweepWidget::forget);
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    m_note->setText(line);
    m_note->show();
  });
}

SweepWidget::~SweepWidget() {
  m_task->abandon();
}

const DesignParameter& SweepWidget::parameter() const {
  return designParameters()[std::size_t(m_parameter->currentIndex())];
}

/// Proposes half of the design's own value to twice of it.
void SweepWidget::propose() {
  const DesignParameter& chosen = parameter();
  const Session& session = m_model->session();
  if (session.cameras.empty()) return;
  const double own =
      std::clamp(chosen.get(session, m_model->currentIndex()), chosen.least, chosen.most);
  const bool isOff = own == 0;
  const auto fill = [&](RealField* field, double value) {
    field->setRange(chosen.least, chosen.most);
    field->setSingleStep(chosen.isWhole ? 1 : (chosen.most - chosen.least) / 1000);
    field->usual = {chosen.least, chosen.most};
    field->unit = chosen.unit;
    field->setValue(std::clamp(value, chosen.least, chosen.most));
  };
  fill(m_from, isOff ? chosen.least : std::ceil(1000 * own / 2) / 1000);
  fill(m_to, isOff ? chosen.most / 2 : 2 * own);
}

void SweepWidget::sweep() {
  Session base = m_model->session();
  base.cameras = {m_model->current()};
  Swept swept{&parameter(), valuesOf(parameter(), m_from->value(), m_to->value()), {}};
  std::vector<Session> designs;
  for (const double value : swept.values)
    designs.push_back(withValue(base, 0, *swept.parameter, value, m_hold()));
  std::vector<std::string> names;
  for (const FigureRow& one : sweptFigures()) names.emplace_back(one.name);
  if (!base.lightField.isLive()) names.pop_back();
  m_task->start([=, this, opening = m_opening](const Progress& progress) mutable {
    swept.rows = measureDesigns(designs, names, progress);
    return [this, swept, opening] {
      if (opening == m_opening) show(swept);
    };
  });
  m_note->hide();
}

void SweepWidget::show(const Swept& swept) {
  m_swept = swept;
  const auto wrong =
      std::ranges::find_if(swept.rows, [](const SweepRow& row) { return !row.problem.empty(); });
  if (wrong != swept.rows.end()) {
    const double value = swept.values[std::size_t(wrong - swept.rows.begin())];
    m_note->setText(swept.parameter->text(value) + ": " + QString::fromStdString(wrong->problem));
    m_note->show();
  }
  Q_EMIT plotChanged();
}

void SweepWidget::forget() {
  m_task->stop();
  ++m_opening;
  m_note->hide();
  m_swept = {};
  propose();
  Q_EMIT plotChanged();
}

Plot SweepWidget::plot() const {
  Plot plot;
  if (m_swept.parameter == nullptr) return plot;
  const auto figure = std::size_t(m_figure->currentIndex());
  plot.titleAcross = m_swept.parameter->label.toStdString();
  if (!m_swept.parameter->unit.isEmpty())
    plot.titleAcross += ", " + m_swept.parameter->unit.toStdString();
  plot.titleUp = m_figure->currentText().toStdString();
  plot.hasCurves = true;
  plot.leastRange = {0, 0.01};
  Plot::Series series;
  for (std::size_t k = 0; k < m_swept.values.size(); ++k) {
    const std::vector<double>& row = m_swept.rows[k].figures;
    if (figure < row.size() && std::isfinite(row[figure]))
      series.points.push_back({.across = m_swept.values[k],
                               .up = row[figure],
                               .title = {},
                               .row = k,
                               .interval = {row[figure], row[figure]}});
  }
  if (!series.points.empty()) plot.series.push_back(series);
  return plot;
}

}  // namespace hogelscope
