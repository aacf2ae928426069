// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/tradeoff_widget.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>

#include "core/base/parallel.h"
#include "gui/docks/plot_saver.h"
#include "gui/widgets/polled_bar.h"
#include "gui/widgets/task.h"

namespace hogelscope {

TradeoffChartWidget::TradeoffChartWidget(QWidget* parent)
    : QWidget(parent),
      m_chart({}, ""),
      m_saver(new PlotSaver(
          this, tr("Speed against accuracy"), {900, 560},
          [this](QPainter& painter, const QSizeF& size) { m_chart.paint(painter, size); })) {
  m_saver->setEnabled(false);
  setMinimumSize(420, 260);
  setObjectName("tradeoffChart");
}

void TradeoffChartWidget::setChart(TradeoffChart chart) {
  m_chart = std::move(chart);
  m_saver->setEnabled(!m_chart.rows().empty());
  update();
}

void TradeoffChartWidget::select(std::optional<std::size_t> row) {
  m_chart.select(row);
  update();
}

void TradeoffChartWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), Qt::white);
  m_chart.paint(painter, QSizeF(size()));
}

void TradeoffChartWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;  // the right button opens the menu
  std::optional<std::size_t> row = m_chart.rowAt(event->position(), QSizeF(size()));
  if (!row) {
    const std::vector<QRectF> names = m_chart.nameBoxes(QSizeF(size()), font());
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k].contains(event->position())) row = k;
  }
  if (row) Q_EMIT clicked(*row);
}

TradeoffWidget::TradeoffWidget(QWidget* parent)
    : QWidget(parent),
      m_task(new Task(this)),
      m_chart(new TradeoffChartWidget(this)),
      m_measureButton(new QPushButton(this)),
      m_budgetBox(new QSpinBox(this)),
      m_defaultButton(new QPushButton(tr("Back to the session's own"), this)),
      m_progress(new PolledBar([this] { return m_task->share(); }, this)) {
  m_measureButton->setObjectName("measureButton");
  m_defaultButton->setObjectName("ownMethodButton");
  m_measureButton->setToolTip(tr("Times every method on all states, and compares their pictures"));
  m_budgetBox->setObjectName("budgetBox");
  m_budgetBox->setRange(1, 24 * 3600);
  m_budgetBox->setValue(int(Budget().seconds));
  m_budgetBox->setPrefix(tr("takes at most "));
  m_budgetBox->setSuffix(tr(" s"));
  m_budgetBox->setToolTip(
      tr("What is slow is measured once and on fewer pixels, so that all methods fit in"));
  m_defaultButton->setToolTip(tr("The live view is rendered as the session says"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_measureButton);
  buttons->addWidget(m_budgetBox);
  buttons->addWidget(m_defaultButton);
  buttons->addWidget(m_progress, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_chart, 1);
  layout->addLayout(buttons);
  forgetChoice();
  showIdle();
  connect(m_measureButton, &QPushButton::clicked, this, &TradeoffWidget::measureOrStop);
  connect(m_defaultButton, &QPushButton::clicked, this, [this] { choose(std::nullopt); });
  connect(m_chart, &TradeoffChartWidget::clicked, this, [this](std::size_t row) { choose(row); });
  connect(m_task, &Task::stopped, this, &TradeoffWidget::showIdle);
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    showIdle();
    Q_EMIT failed(line);
  });
}

void TradeoffWidget::forget(bool canMeasure) {
  m_canMeasure = canMeasure;
  m_views.clear();
  if (!m_chart->chart().rows().empty()) m_chart->setChart(TradeoffChart({}, ""));
  if (m_task->isRunning())
    stop();
  else
    showIdle();
}

void TradeoffWidget::forgetChoice() {
  m_chart->select(std::nullopt);
  m_defaultButton->setEnabled(false);
}

void TradeoffWidget::stop() {
  m_task->stop();
  m_measureButton->setText(tr("Stopping…"));
  m_measureButton->setEnabled(false);
}

void TradeoffWidget::measureOrStop() {
  if (m_task->isRunning()) return stop();
  m_measureButton->setText(tr("&Stop measuring"));
  m_budgetBox->setEnabled(false);
  m_views = m_viewsNow();
  Budget budget;
  budget.seconds = m_budgetBox->value();
  m_task->start([this, budget, views = m_views](const Progress& progress) {
    return [this, tradeoff = measureTradeoff(views, budget, parallelRows, progress)] {
      show(tradeoff);
    };
  });
  m_progress->setVisible(true);
}

void TradeoffWidget::show(const Tradeoff& tradeoff) {
  const bool isWanted = m_measureButton->isEnabled();  // no stop was requested just before the end
  showIdle();
  if (!isWanted) return;
  const std::string question = questionText(questionOf(m_views.front().sampling));
  const QString title = tr("Error against %1").arg(QString::fromStdString(question));
  m_chart->setChart(TradeoffChart(tradeoff.rows, title.toStdString()));
}

void TradeoffWidget::choose(std::optional<std::size_t> row) {
  m_chart->select(row);
  m_defaultButton->setEnabled(row.has_value());
  if (row)
    Q_EMIT methodChosen(methodsFor(m_views)[*row]);
  else
    Q_EMIT methodChosen(std::nullopt);
}

void TradeoffWidget::showIdle() {
  m_measureButton->setText(tr("&Measure speed and accuracy"));
  m_measureButton->setEnabled(m_canMeasure);
  m_budgetBox->setEnabled(m_canMeasure);
  m_progress->setVisible(false);
}

}  // namespace hogelscope
