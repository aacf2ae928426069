// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/sweep_widget.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/session/session_forms.h"
#include "gui/widgets/task_widgets.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr std::size_t mostValues = 12;  // of a sweep

/// Returns the figures that a sweep may measure, in the order in which they are offered.
const std::vector<FigureRow>& sweptFigures() {
  static const std::vector<FigureRow> all = [] {
    std::vector<FigureRow> figures;
    std::ranges::copy_if(figureRows(), std::back_inserter(figures), &FigureRow::inWindow);
    std::ranges::sort(figures, {}, &FigureRow::inWindow);
    return figures;
  }();
  return all;
}

QString unitOf(const FigureRow& figure) {
  return QString::fromUtf8(figure.unit.data(), qsizetype(figure.unit.size()));
}

/// Whether a sweep measures a figure: a unit's errors change views alone. Views of the ideal need a
/// live scene, and other designs have no picture where a file has the content of one.
bool isMeasured(const FigureRow& figure, const Session& session, const DesignParameter& parameter) {
  if (figure.sweptWith != SweptWith::views) return !parameter.isOfTwin;
  if (session.lightField.isLive()) return true;
  return figure.name == "psnr:design" && parameter.isOfTwin;
}

/// Returns the values of a sweep, evenly spaced as the parameter's slider is, and round.
std::vector<double> valuesOf(const DesignParameter& parameter, double from, double to) {
  std::vector<double> values;
  const double digit = std::pow(10, std::floor(std::log10(std::max(std::abs(to - from), 1e-300))));
  for (std::size_t k = 0; k < mostValues; ++k) {
    const double share = double(k) / (mostValues - 1);
    if (parameter.isLogarithmic) {
      const double first = parameter.shareOf(from);
      values.push_back(parameter.at(first + (parameter.shareOf(to) - first) * share));
    } else {
      const double step = parameter.isWhole ? 1 : digit / 1000;
      const double value = step * std::round((from + (to - from) * share) / step);
      values.push_back(QString::number(value, 'g', 12).toDouble());
    }
  }
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
  return values;
}

QString inFewDigits(double value) {
  return QLocale().toString(value, 'g', 3);
}

}  // namespace

SweepWidget::SweepWidget(SessionModel* model, std::function<Hold()> hold, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_hold(std::move(hold)),
      m_task(new Task(this)),
      m_parameter(new QComboBox),
      m_figure(new QComboBox),
      m_sense(new QComboBox),
      m_from(new RealField(this)),
      m_to(new RealField(this)),
      m_limit(new RealField(this)),
      m_answer(new QLabel),
      m_note(new QLabel) {
  m_parameter->setObjectName("sweepParameter");
  m_figure->setObjectName("sweepFigure");
  m_from->setObjectName("sweepFrom");
  m_to->setObjectName("sweepTo");
  m_note->setObjectName("sweepNote");
  m_note->hide();
  m_answer->setObjectName("sweepAnswer");
  for (QLabel* label : {m_note, m_answer}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
  }
  addChoices();
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
  auto* limit = new QHBoxLayout;
  limit->addWidget(m_sense, 1);
  limit->addWidget(m_limit, 1);
  form->addRow(tr("Limit"), limit);
  form->addRow(m_answer);
  form->addRow(m_note);
  connect(m_parameter, &QComboBox::currentIndexChanged, this, &SweepWidget::chooseParameter);
  connect(m_figure, &QComboBox::currentIndexChanged, this, &SweepWidget::chooseFigure);
  connect(m_sense, &QComboBox::currentIndexChanged, this, &SweepWidget::keepLimit);
  connect(m_limit, &RealField::valueChanged, this, &SweepWidget::keepLimit);
  onAnyChange(m_model, this, [this] { Q_EMIT plotChanged(); });  // the design's mark
  connect(m_model, &SessionModel::opened, this, &SweepWidget::forget);
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    m_note->setText(line);
    m_note->show();
  });
}

SweepWidget::~SweepWidget() {
  m_task->abandon();
}

void SweepWidget::addChoices() {
  for (const DesignParameter& one : sweptParameters()) m_parameter->addItem(one.label);
  m_parameter->setCurrentIndex(1);
  for (const FigureRow& one : sweptFigures()) {
    const QString unit = unitOf(one);
    m_figure->addItem(unit.isEmpty() ? tr(one.title) : tr(one.title) + ", " + unit);
    constexpr double goodPsnr = 30;  // dB
    m_limits.push_back(
        {!one.isBetterLess, one.unit == "dB" ? std::optional(goodPsnr) : std::nullopt});
  }
  m_sense->addItems({tr("at least"), tr("at most")});
  m_sense->setObjectName("sweepSense");
  m_limit->setObjectName("sweepLimit");
  m_limit->setToolTip(tr("A line in the chart; where the curve crosses it is said below"));
  constexpr double most = 1e9;
  m_limit->setRange(-most, most);
  m_limit->mayBeLeftOut();
  m_parameter->setMaxVisibleItems(24);
  for (QComboBox* box : {m_parameter, m_figure, m_sense})
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  showLimit();
}

const DesignParameter& SweepWidget::parameter() const {
  return sweptParameters()[std::size_t(m_parameter->currentIndex())];
}

const FigureRow& SweepWidget::figure() const {
  return sweptFigures()[std::size_t(m_figure->currentIndex())];
}

/// Errors of a unit change its pictures alone, so that these are what is drawn.
void SweepWidget::chooseParameter() {
  propose();
  if (!parameter().isOfTwin || figure().sweptWith == SweptWith::views) return;
  const auto ofDesign = std::ranges::find(sweptFigures(), "psnr:design", &FigureRow::name);
  m_figure->setCurrentIndex(int(ofDesign - sweptFigures().begin()));
}

void SweepWidget::chooseFigure() {
  showLimit();
  showAnswer();
}

/// Shows the limit of the chosen figure.
void SweepWidget::showLimit() {
  const Limit limit = m_limits[std::size_t(m_figure->currentIndex())];
  const QSignalBlocker quietSense(m_sense), quietLimit(m_limit);
  m_sense->setCurrentIndex(limit.isLeast ? 0 : 1);
  m_limit->unit = unitOf(figure());
  m_limit->setValue(limit.value.value_or(m_limit->minimum()));
  m_limit->update();
}

void SweepWidget::keepLimit() {
  const bool isGiven = m_limit->value() > m_limit->minimum();
  m_limits[std::size_t(m_figure->currentIndex())] = {
      m_sense->currentIndex() == 0, isGiven ? std::optional(m_limit->value()) : std::nullopt};
  showAnswer();
}

/// Proposes half of the design's own value to twice of it; of an error, as much to both sides.
void SweepWidget::propose() {
  const DesignParameter& chosen = parameter();
  const Session& session = m_model->session();
  if (session.cameras.empty()) return;
  const double own =
      std::clamp(chosen.get(session, m_model->currentIndex()), chosen.least, chosen.most);
  const bool isOff = own == 0;
  const auto fill = [&](RealField* field, double value) {
    field->setRange(chosen.least, chosen.most);
    field->setSingleStep(chosen.isWhole ? 1 : (chosen.usualMost - chosen.usualLeast) / 1000);
    field->usual = {chosen.usualLeast, chosen.usualMost};
    field->unit = chosen.unit;
    field->setValue(std::clamp(value, chosen.least, chosen.most));
  };
  if (chosen.least < 0) {
    const double reach = isOff ? chosen.usualMost / 5 : 2 * std::abs(own);
    fill(m_from, -reach);
    return fill(m_to, reach);
  }
  fill(m_from, isOff ? chosen.least : std::ceil(1000 * own / 2) / 1000);
  fill(m_to, isOff ? chosen.usualMost / 2 : 2 * own);
}

void SweepWidget::sweep() {
  Session base = m_model->session();
  base.cameras = {m_model->current()};
  Swept swept{&parameter(), m_hold(), valuesOf(parameter(), m_from->value(), m_to->value())};
  std::vector<Session> designs;
  for (const double value : swept.values)
    designs.push_back(withValue(base, 0, *swept.parameter, value, swept.hold));
  for (const FigureRow& one : sweptFigures())
    if (isMeasured(one, base, parameter())) swept.figures.emplace_back(one.name);
  // Without its errors, but in the light that they need.
  const Session design = withTwin(parameter().isOfTwin ? designs.back() : base, {});
  m_task->start([=, this, opening = m_opening](const Progress& progress) mutable {
    swept.rows = measureDesigns(designs, design, swept.figures, progress);
    return [this, swept, opening] {
      if (opening == m_opening) show(swept);
    };
  });
  m_note->hide();
}

void SweepWidget::show(const Swept& swept) {
  m_swept = swept;
  m_hovered.reset();
  const auto wrong =
      std::ranges::find_if(swept.rows, [](const SweepRow& row) { return !row.problem.empty(); });
  if (wrong != swept.rows.end()) {
    const double value = swept.values[std::size_t(wrong - swept.rows.begin())];
    m_note->setText(swept.parameter->text(value) + ": " + QString::fromStdString(wrong->problem));
    m_note->show();
  }
  showAnswer();
}

/// Says where the curve is within the limit, by straight lines between its points.
void SweepWidget::showAnswer() {
  m_answer->setText(answer());
  m_answer->setVisible(!m_answer->text().isEmpty());
  Q_EMIT plotChanged();
}

QString SweepWidget::answer() const {
  const Limit limit = m_limits[std::size_t(m_figure->currentIndex())];
  const Plot shown = plot();
  if (!limit.value || shown.series.empty()) return {};
  std::vector<std::array<double, 2>> points;
  for (const Plot::Point& point : shown.series.front().points)
    points.push_back({point.across, point.up});
  SweepLimit bounds{std::string(figure().name)};
  (limit.isLeast ? bounds.least : bounds.most) = *limit.value;
  const QString unit = unitOf(figure());
  const QString condition = tr(figure().title) + (limit.isLeast ? " ≥ " : " ≤ ") +
                            QLocale().toString(*limit.value, 'g', 4) +
                            (unit.isEmpty() ? QString() : " " + unit);
  QStringList places;
  for (const LimitSpan& span : spansWithin(points, bounds)) places << placeText(span);
  if (places.isEmpty()) return tr("%1: nowhere in this range").arg(condition);
  const QString own = m_swept.parameter->unit;
  return QString("%1: %2%3")
      .arg(condition, places.join(tr(" and ")), own.isEmpty() ? QString() : " " + own);
}

/// Returns "± 0.012", whose sign stays beside it, "−0.01 … 0.02", "up to 0.012", "from 0.3 on" or
/// "all of 0.1 … 0.3".
QString SweepWidget::placeText(const LimitSpan& span) {
  constexpr double alike = 0.05;
  const QString from = inFewDigits(span.from);
  const QString to = inFewDigits(span.to);
  const QString range = from + " … " + to;
  if (!span.beginsThere && !span.endsThere) return tr("all of %1").arg(range);
  if (!span.beginsThere) return tr("up to %1").arg(to);
  if (!span.endsThere) return tr("from %1 on").arg(from);
  if (std::abs(span.from + span.to) > alike * (span.to - span.from)) return range;
  return "± " + inFewDigits(std::min(-span.from, span.to));
}

void SweepWidget::hover(std::optional<std::size_t> row) {
  if (std::exchange(m_hovered, row) != row) Q_EMIT plotChanged();
}

void SweepWidget::apply(std::size_t row) {
  if (m_swept.parameter == nullptr || row >= m_swept.values.size() || m_task->isRunning()) return;
  const DesignParameter& chosen = *m_swept.parameter;
  m_model->edit(tr("Change %1").arg(chosen.label.toLower()), [&](Session& session) {
    session =
        withValue(session, m_model->currentIndex(), chosen, m_swept.values[row], m_swept.hold);
  });
}

void SweepWidget::forget() {
  m_task->stop();
  ++m_opening;
  m_note->hide();
  m_swept = {};
  m_hovered.reset();
  propose();
  showAnswer();
}

Plot SweepWidget::plot() const {
  Plot plot;
  if (m_swept.parameter == nullptr) return plot;
  const DesignParameter& swept = *m_swept.parameter;
  plot.titleAcross = swept.label.toStdString();
  if (!swept.unit.isEmpty()) plot.titleAcross += ", " + swept.unit.toStdString();
  plot.titleUp = m_figure->currentText().toStdString();
  plot.hasCurves = true;
  plot.leastRange = {0, 0.01};
  const auto column = std::ranges::find(m_swept.figures, std::string(figure().name));
  const auto at = std::size_t(column - m_swept.figures.begin());
  const QString unit = unitOf(figure());
  Plot::Series series;
  for (std::size_t k = 0; k < m_swept.values.size(); ++k) {
    const std::vector<double>& row = m_swept.rows[k].figures;
    if (at >= row.size() || !std::isfinite(row[at])) continue;
    const QString value = QLocale().toString(row[at], 'g', 4);
    series.points.push_back(
        {.across = m_swept.values[k],
         .up = row[at],
         .title = {},
         .row = k,
         .interval = {row[at], row[at]},
         .name = (swept.text(m_swept.values[k]) + ": " + value + " " + unit).toStdString()});
  }
  if (series.points.empty()) return plot;
  plot.series.push_back(series);
  plot.limit = m_limits[std::size_t(m_figure->currentIndex())].value;
  if (!m_model->session().cameras.empty())
    plot.mark = swept.get(m_model->session(), m_model->currentIndex());
  plot.markName = tr("now").toStdString();
  return plot;
}

}  // namespace hogelscope
