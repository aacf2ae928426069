// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/task_widgets.h"

#include <QHBoxLayout>
#include <QStatusBar>
#include <QToolButton>
#include <utility>

namespace hogelscope {

void TaskButton::control(Task* task, const std::function<void()>& start) {
  m_task = task;
  m_idleText = text();
  connect(this, &QPushButton::clicked, this,
          [this, start] { m_task->isRunning() ? stop() : start(); });
  connect(task, &Task::runningChanged, this, &TaskButton::follow);
}

void TaskButton::setIdle(const QString& text, bool canStart) {
  m_idleText = text;
  m_canStart = canStart;
  if (!m_task->isRunning()) follow();
}

void TaskButton::stop() {
  m_task->stop();
  setText(tr("Stopping…"));
  setEnabled(false);
}

void TaskButton::follow() {
  setText(m_task->isRunning() ? tr("&Stop") : m_idleText);
  setEnabled(m_task->isRunning() || m_canStart);
}

PolledBar::PolledBar(Share share, QWidget* parent)
    : QProgressBar(parent), m_share(std::move(share)) {
  constexpr int interval = 100;  // milliseconds
  constexpr int steps = 1000;
  m_timer.setInterval(interval);
  setRange(0, steps);
  connect(&m_timer, &QTimer::timeout, this, &PolledBar::ask);
}

PolledBar::PolledBar(Task* task, QWidget* parent)
    : PolledBar([task] { return task->share(); }, parent) {
  QSizePolicy policy = sizePolicy();
  policy.setRetainSizeWhenHidden(true);  // what stands beside it stays where it is
  setSizePolicy(policy);
  hide();
  connect(task, &Task::runningChanged, this, &QWidget::setVisible);
}

void PolledBar::ask() {
  setValue(int(maximum() * m_share()));
}

void PolledBar::showEvent(QShowEvent* event) {
  ask();
  m_timer.start();
  QProgressBar::showEvent(event);
}

void PolledBar::hideEvent(QHideEvent* event) {
  m_timer.stop();
  QProgressBar::hideEvent(event);
}

ReadingBar::ReadingBar(const QString& what, PolledBar::Share share, QWidget* parent,
                       const QString& barHelp, const QString& stopHelp)
    : QWidget(parent) {
  auto* bar = new PolledBar(std::move(share));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  bar->setMaximumHeight(fontMetrics().height() + 4);
  bar->setMinimumWidth(fontMetrics().horizontalAdvance(what) * 2);
  bar->setFormat(tr("%1: %p %").arg(what));
  bar->setToolTip(barHelp);
  auto* button = new QToolButton;
  button->setText(tr("Stop"));
  button->setToolTip(stopHelp);
  connect(button, &QToolButton::clicked, this, &ReadingBar::stopAsked);
  layout->addWidget(bar);
  layout->addWidget(button);
  hide();
}

FileOutput::FileOutput(const char* bar, const QString& what, const QString& help,
                       QStatusBar* statusBar, QObject* parent)
    : QObject(parent), m_task(new Task(this)) {
  auto* writing = new ReadingBar(
      what, [this] { return m_task->share(); }, statusBar, help,
      tr("Stops, and leaves no file behind"));
  writing->setObjectName(bar);
  statusBar->addPermanentWidget(writing);
  connect(writing, &ReadingBar::stopAsked, m_task, &Task::stop);
  connect(m_task, &Task::runningChanged, writing, &QWidget::setVisible);
  connect(m_task, &Task::stopped, this,
          [this] { Q_EMIT done(tr("Stopped; nothing was written")); });
  connect(m_task, &Task::failed, this, &FileOutput::failed);
}

}  // namespace hogelscope
