// SPDX-License-Identifier: BSD-3-Clause
// The speed-accuracy dock.
#include "gui/docks/tradeoff_view.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>

#include "gui/docks/tradeoff_worker.h"
#include "gui/widgets/polled_bar.h"

namespace hogelscope {

TradeoffChartWidget::TradeoffChartWidget(QWidget* parent) : QWidget(parent), m_chart({}, "") {
  setMinimumSize(420, 260);
  setObjectName("tradeoffChart");
}

void TradeoffChartWidget::setChart(TradeoffChart chart) {
  m_chart = std::move(chart);
  m_painted = {};
  update();
}

void TradeoffChartWidget::select(std::optional<std::size_t> row) {
  m_chart.select(row);
  m_painted = {};
  update();
}

void TradeoffChartWidget::paintEvent(QPaintEvent*) {
  const QSize pixels = size() * devicePixelRatio();
  if (m_painted.size() != pixels) {
    m_painted = QPixmap(pixels);
    m_painted.setDevicePixelRatio(devicePixelRatio());
    m_painted.fill(Qt::white);
    QPainter painter(&m_painted);
    painter.setRenderHint(QPainter::Antialiasing);
    m_chart.paint(painter, QSizeF(size()));
  }
  QPainter(this).drawPixmap(0, 0, m_painted);
}

void TradeoffChartWidget::mousePressEvent(QMouseEvent* event) {
  std::optional<std::size_t> row = m_chart.rowAt(event->position(), QSizeF(size()));
  if (!row) {
    const std::vector<QRectF> names = m_chart.nameBoxes(QSizeF(size()), font());
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k].contains(event->position())) row = k;
  }
  if (row) Q_EMIT clicked(*row);
}

TradeoffView::TradeoffView(QWidget* parent)
    : QWidget(parent),
      m_worker(new TradeoffWorker(this)),
      m_chart(new TradeoffChartWidget(this)),
      m_measureButton(new QPushButton(this)),
      m_defaultButton(new QPushButton(tr("Back to the session's own"), this)),
      m_progress(new PolledBar([this] { return m_worker->share(); }, this)) {
  m_measureButton->setObjectName("measureButton");
  m_defaultButton->setObjectName("ownMethodButton");
  m_measureButton->setToolTip(tr("Times every method on all states, and compares their pictures"));
  m_defaultButton->setToolTip(tr("The live view is rendered as the session says"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_measureButton);
  buttons->addWidget(m_defaultButton);
  buttons->addWidget(m_progress, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_chart, 1);
  layout->addLayout(buttons);
  forgetChoice();
  showIdle();
  connect(m_measureButton, &QPushButton::clicked, this, &TradeoffView::measureOrStop);
  connect(m_defaultButton, &QPushButton::clicked, this, [this] { choose(std::nullopt); });
  connect(m_chart, &TradeoffChartWidget::clicked, this, [this](std::size_t row) { choose(row); });
  connect(m_worker, &TradeoffWorker::finished, this, &TradeoffView::show);
  connect(m_worker, &TradeoffWorker::stopped, this, &TradeoffView::showIdle);
  connect(m_worker, &TradeoffWorker::failed, this, [this](const QString& line) {
    showIdle();
    Q_EMIT failed(line);
  });
}

void TradeoffView::setViews(const std::vector<View>& views) {
  m_views = views;
  m_chart->setChart(TradeoffChart({}, ""));
  if (m_isMeasuring)
    stop();
  else
    showIdle();
}

void TradeoffView::forgetChoice() {
  m_chart->select(std::nullopt);
  m_defaultButton->setEnabled(false);
}

void TradeoffView::stop() {
  m_worker->stop();
  m_measureButton->setText(tr("Stopping…"));
  m_measureButton->setEnabled(false);
}

void TradeoffView::measureOrStop() {
  if (m_isMeasuring) return stop();
  m_isMeasuring = true;
  m_measureButton->setText(tr("&Stop measuring"));
  m_worker->start(m_views);
  m_progress->setVisible(true);
}

void TradeoffView::show(const Tradeoff& tradeoff) {
  const bool isWanted = m_measureButton->isEnabled();  // nobody said stop just before its end
  showIdle();
  if (!isWanted) return;
  const std::string question = questionText(questionOf(m_views.front().sampling));
  const QString title = tr("Error against %1").arg(QString::fromStdString(question));
  m_chart->setChart(TradeoffChart(tradeoff.rows, title.toStdString()));
}

void TradeoffView::choose(std::optional<std::size_t> row) {
  m_chart->select(row);
  m_defaultButton->setEnabled(row.has_value());
  if (row)
    Q_EMIT methodChosen(namedMethods()[*row]);
  else
    Q_EMIT methodChosen(std::nullopt);
}

void TradeoffView::showIdle() {
  m_isMeasuring = false;
  m_measureButton->setText(tr("&Measure speed and accuracy"));
  m_measureButton->setEnabled(!m_views.empty());
  m_progress->setVisible(false);
}

}  // namespace hogelscope
