// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/polled_bar.h"

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

}  // namespace hogelscope
