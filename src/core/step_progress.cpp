// SPDX-License-Identifier: BSD-3-Clause
// Progress of work in steps, done on several threads.
#include "core/step_progress.h"

namespace hogelscope {

bool StepProgress::tell(double within) {
  constexpr std::chrono::milliseconds pause{20};
  const std::lock_guard lock(m_mutex);
  const auto now = std::chrono::steady_clock::now();
  if (m_stops || now - m_told < pause) return !m_stops;
  m_told = now;
  m_stops = m_listener && !m_listener(m_total > 0 ? (m_done + within) / m_total : 0);
  return !m_stops;
}

void StepProgress::finish(double steps) {
  {
    const std::lock_guard lock(m_mutex);
    m_done += steps;
  }
  if (!tell(0)) throw Cancelled();
}

Progress StepProgress::within() {
  return [this](double) { return tell(0); };
}

Progress StepProgress::of(double steps) {
  return [this, steps](double done) { return tell(steps * done); };
}

}  // namespace hogelscope
