// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/polled_bar.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <utility>

namespace hogelscope {

PolledBar::PolledBar(Share share, QWidget* parent)
    : QProgressBar(parent), m_share(std::move(share)) {
  constexpr int interval = 100;  // milliseconds
  constexpr int steps = 1000;
  m_timer.setInterval(interval);
  setRange(0, steps);
  connect(&m_timer, &QTimer::timeout, this, &PolledBar::ask);
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

}  // namespace hogelscope
