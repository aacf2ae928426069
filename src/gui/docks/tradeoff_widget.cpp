// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/tradeoff_widget.h"

#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "chart/method_texts.h"
#include "core/base/parallel.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/plot_saver.h"
#include "gui/widgets/task_widgets.h"
#include "ui_tradeoff_widget.h"

namespace hogelscope {

namespace {

enum Column { nameColumn, timeColumn, rateColumn, errorColumn };

QIcon markerIcon(const TradeoffRow& row, double ratio) {
  return pixmapOf(scaled(16), ratio, [&row](QPainter& painter, const QSizeF& size) {
    ChartColours colours = chartColours();
    colours.background = Qt::transparent;
    paintMarker(painter, {size.width() / 2, size.height() / 2}, 0.3 * size.width(), row, colours);
  });
}

}  // namespace

TradeoffChartWidget::TradeoffChartWidget(QWidget* parent)
    : QWidget(parent),
      m_chart({}, ""),
      m_saver(new PlotSaver(
          this, tr("Speed against accuracy"), {720, 520},
          [this](QPainter& painter, const QSizeF& size) { m_chart.paintFile(painter, size); })),
      m_details(new QLabel(this)) {
  m_saver->setEnabled(false);
  setMinimumSize(320, 80);
  setMouseTracking(true);
  m_details->setObjectName("methodDetails");
  m_details->setTextFormat(Qt::RichText);
  m_details->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_details->hide();
}

void TradeoffChartWidget::setChart(TradeoffChart chart) {
  point(std::nullopt);
  m_chart = std::move(chart);
  m_saver->setEnabled(!m_chart.rows().empty());
  update();
}

void TradeoffChartWidget::select(std::optional<std::size_t> row) {
  m_chart.select(row);
  update();
}

void TradeoffChartWidget::point(std::optional<std::size_t> row) {
  if (row == m_chart.pointed()) return;
  m_chart.point(row);
  m_details->setVisible(row.has_value());
  update();
  if (!row) return;
  const auto place = m_chart.axes(QSizeF(size()), chartFont()).positionOf(m_chart.rows()[*row]);
  m_details->setText(detailsOf(m_chart.rows(), *row, chartColours(), scaled(int(TextSize::base))));
  m_details->adjustSize();
  const int gap = scaled(16);
  QPoint corner = place->toPoint() + QPoint(gap, -gap - m_details->height());
  if (corner.x() + m_details->width() > width()) corner.rx() -= 2 * gap + m_details->width();
  if (corner.y() < 0) corner.ry() += 2 * gap + m_details->height();
  m_details->move(std::max(0, corner.x()), corner.y());
}

void TradeoffChartWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(chartFont());
  const ChartColours colours = chartColours();
  painter.fillRect(rect(), colours.background);
  if (!m_chart.rows().empty()) return m_chart.paint(painter, QSizeF(size()), colours);
  painter.setPen(colours.text2);
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                   tr("Nothing is measured yet. Measuring times every method on the session's "
                      "states and compares its pictures with the reference."));
}

std::optional<std::size_t> TradeoffChartWidget::rowAt(const QPointF& place) const {
  return m_chart.rowAt(place, QSizeF(size()), chartFont());
}

void TradeoffChartWidget::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<std::size_t> row = rowAt(event->position());
  setCursor(row ? Qt::PointingHandCursor : Qt::ArrowCursor);
  point(row);
}

void TradeoffChartWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;  // the right button opens the menu
  if (const auto row = rowAt(event->position())) Q_EMIT clicked(*row);
}

void TradeoffChartWidget::leaveEvent(QEvent*) {
  point(std::nullopt);
}

TradeoffWidget::TradeoffWidget(QWidget* parent)
    : QWidget(parent), m_ui(std::make_unique<Ui::TradeoffWidget>()), m_task(new Task(this)) {
  m_ui->setupUi(this);
  m_ui->budgetBox->setValue(int(Budget().seconds));
  m_ui->ownMethodButton->setIcon(icon("reset"));
  QHeaderView* header = m_ui->methodTable->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
  m_cards = {m_ui->movingViewCard, m_ui->defaultCard, m_ui->paperCard};
  connectParts();
  show(m_question);
}

TradeoffWidget::~TradeoffWidget() = default;

void TradeoffWidget::connectParts() {
  // A widget that is shown widens the dock at once if it has no room, so the bar comes after the
  // button's short text and goes before the status is shown. Slots are called in this order.
  m_ui->measureButton->control(m_task, [this] { measure(); });
  m_ui->heading->insertWidget(m_ui->heading->indexOf(m_ui->tradeoffStatus),
                              new PolledBar(m_task, this), 1);
  connect(m_task, &Task::runningChanged, this, [this] { show(m_question); });
  connect(m_ui->ownMethodButton, &QPushButton::clicked, this, [this] { choose(std::nullopt); });
  connect(m_ui->tradeoffChart, &TradeoffChartWidget::clicked, this,
          [this](std::size_t row) { choose(row); });
  const auto chooseLine = [this](int line) { choose(rowOfLine(line)); };
  connect(m_ui->methodTable, &QTableWidget::cellClicked, this, chooseLine);
  connect(m_ui->methodTable, &QTableWidget::cellActivated, this, chooseLine);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before) {
    if (before == m_ui->methodTable) m_ui->tradeoffChart->point(std::nullopt);
  });
  connect(m_ui->methodTable, &QTableWidget::currentCellChanged, this, [this](int line) {
    if (m_ui->methodTable->hasFocus() && line >= 0) m_ui->tradeoffChart->point(rowOfLine(line));
  });
  connect(m_ui->displayQuestion, &QToolButton::clicked, this,
          [this] { show(Question::displayAsBuilt); });
  connect(m_ui->idealQuestion, &QToolButton::clicked, this,
          [this] { show(Question::idealPicture); });
  for (const Purpose purpose : purposes)
    connect(m_cards[std::size_t(purpose)], &QPushButton::clicked, this,
            [this, purpose] { choose(recommended(rows(), purpose)); });
  connect(m_task, &Task::failed, this, &TradeoffWidget::failed);
}

bool TradeoffWidget::event(QEvent* event) {
  if (event->type() == QEvent::Resize) arrange();
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
    show(m_question);
  return QWidget::event(event);
}

/// Whether each card is one line.
bool TradeoffWidget::isLow() const {
  return height() < scaled(240);
}

const std::vector<TradeoffRow>& TradeoffWidget::rows() const {
  return m_ui->tradeoffChart->chart().rows();
}

/// Shows what fits: chart and heading always, cards and table when something is measured.
void TradeoffWidget::arrange() {
  constexpr int wide = 900;  // px; the table is beside the chart from here on
  constexpr int lowWithTable = 360;
  constexpr int lowWithTableBelow = 600;
  const bool isMeasured = !rows().empty();
  const bool isWide = width() >= scaled(wide);
  m_ui->body->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  m_ui->methodTable->setVisible(isMeasured &&
                                height() >= scaled(isWide ? lowWithTable : lowWithTableBelow));
  for (QPushButton* card : m_cards) {
    card->setFixedHeight(scaled(isLow() ? 28 : 72));
    card->setVisible(isMeasured);
  }
  showChoice();
}

void TradeoffWidget::forget(bool canMeasure) {
  m_canMeasure = canMeasure;
  m_results = {};
  show(m_question);
  if (m_task->isRunning()) m_ui->measureButton->stop();
}

void TradeoffWidget::forgetChoice() {
  m_chosen.clear();
  showChoice();
}

void TradeoffWidget::measure() {
  std::vector<RenderJob> views = m_viewsNow();
  ask(m_question, views);
  Budget budget;
  budget.seconds = m_ui->budgetBox->value();
  m_ui->tradeoffStatus->hide();
  m_task->start(
      [this, budget, question = m_question, views = std::move(views)](const Progress& progress) {
        const double start = budget.clock();
        const Tradeoff tradeoff = measureTradeoff(views, budget, parallelRows, progress, true);
        const double seconds = budget.clock() - start;
        return [this, question, seconds, tradeoff] {
          if (!m_ui->measureButton->isEnabled())
            return;  // a stop was requested just before the end
          m_results[std::size_t(question)] = {tradeoff.rows, seconds};
          m_results[1 - std::size_t(question)] = {tradeoff.otherRows, seconds};
        };
      });
}

/// Shows what is measured for the question.
void TradeoffWidget::show(Question question) {
  m_question = question;
  const bool isIdeal = question == Question::idealPicture;
  (isIdeal ? m_ui->idealQuestion : m_ui->displayQuestion)->setChecked(true);
  const std::vector<TradeoffRow>& rows = m_results[std::size_t(m_question)].rows;
  m_ui->tradeoffChart->setChart(TradeoffChart(rows, "Error"));
  fillTable(rows);
  arrange();
  showTask();
}

void TradeoffWidget::fillTable(const std::vector<TradeoffRow>& rows) {
  m_ui->methodTable->setRowCount(0);
  m_ui->methodTable->verticalHeader()->setDefaultSectionSize(scaled(24));
  for (const std::size_t k : fastToSlow(rows)) {
    const TradeoffRow& row = rows[k];
    const int line = m_ui->methodTable->rowCount();
    m_ui->methodTable->insertRow(line);
    const QStringList texts{nameOf(rows, k), figureText(row.milliseconds), rateText(row),
                            errorText(row)};
    for (int column = nameColumn; column <= errorColumn; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setForeground(row.isPareto ? tokens().text : tokens().text2);
      if (column > nameColumn) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      m_ui->methodTable->setItem(line, column, item);
    }
    m_ui->methodTable->item(line, nameColumn)->setIcon(markerIcon(row, devicePixelRatioF()));
  }
}

std::size_t TradeoffWidget::rowOfLine(int line) const {
  return fastToSlow(rows())[std::size_t(line)];
}

void TradeoffWidget::choose(std::optional<std::size_t> row) {
  std::optional<NamedMethod> method;
  const std::vector<NamedMethod> methods = namedMethods();
  if (row) method = *std::ranges::find(methods, rows()[*row].method, &NamedMethod::name);
  m_chosen = method ? QString::fromStdString(method->name) : QString();
  showChoice();
  Q_EMIT methodChosen(method);
}

/// Shows what was measured, if the heading has room for the whole sentence.
void TradeoffWidget::showStatus() {
  const auto& [rows, seconds] = m_results[std::size_t(m_question)];
  const QString words =
      tr("%1 methods measured in %2 s").arg(rows.size()).arg(seconds, 0, 'f', seconds < 10 ? 1 : 0);
  const int room = width() - m_ui->heading->minimumSize().width();
  const bool fits = m_ui->tradeoffStatus->fontMetrics().horizontalAdvance(words) < room;
  m_ui->tradeoffStatus->setText(fits && !rows.empty() ? words : QString());
}

/// Marks the chosen method in chart, table and cards.
void TradeoffWidget::showChoice() {
  m_ui->ownMethodButton->setVisible(!m_chosen.isEmpty());
  showStatus();
  const std::vector<TradeoffRow>& rows = this->rows();
  const auto found = std::ranges::find(rows, m_chosen.toStdString(), &TradeoffRow::method);
  std::optional<std::size_t> row;
  if (found != rows.end()) row = std::size_t(found - rows.begin());
  m_ui->tradeoffChart->select(row);
  for (const Purpose purpose : purposes) {
    const std::optional<std::size_t> best = recommended(rows, purpose);
    if (!best) continue;
    std::vector<Purpose> alike;  // one card is for all purposes that have the same method
    for (const Purpose other : purposes)
      if (recommended(rows, other) == best) alike.push_back(other);
    QPushButton* card = m_cards[std::size_t(purpose)];
    card->setVisible(alike.front() == purpose);
    card->setChecked(row == best);
    card->setAccessibleName(QString::fromStdString(rows[*best].method));
    card->findChild<QLabel*>()->setText(cardText(alike, rows[*best], row == best, isLow(),
                                                 chartColours(), scaled(int(TextSize::base))));
  }
  if (!row) return m_ui->methodTable->clearSelection();
  const auto lines = fastToSlow(rows);
  m_ui->methodTable->selectRow(int(std::ranges::find(lines, *row) - lines.begin()));
}

void TradeoffWidget::showTask() {
  const bool isMeasured = !m_results[std::size_t(m_question)].rows.empty();
  const bool isRunning = m_task->isRunning();
  m_ui->measureButton->setIdle(isMeasured ? tr("&Measure again") : tr("&Measure"), m_canMeasure);
  m_ui->measureButton->setIcon(icon(isRunning ? "stop" : "measure"));
  m_ui->budgetBox->setEnabled(m_canMeasure && !isRunning);
  m_ui->tradeoffStatus->setVisible(!isRunning);
}

}  // namespace hogelscope
