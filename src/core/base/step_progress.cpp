// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/step_progress.h"

namespace hogelscope {

bool StepProgress::tell(double within) const {
  return !m_listener || m_listener(m_total > 0 ? (m_done + within) / m_total : 0);
}

void StepProgress::finish(double steps) {
  m_done += steps;
  if (!tell(0)) throw Cancelled();
}

Progress StepProgress::within() {
  return [this](double) { return tell(0); };
}

Progress StepProgress::of(double steps) {
  return [this, steps](double done) { return tell(steps * done); };
}

}  // namespace hogelscope
