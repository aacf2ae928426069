// SPDX-License-Identifier: BSD-3-Clause
// Progress of work in steps of different length on several threads.
#pragma once

#include <atomic>

#include "core/base/progress.h"

namespace hogelscope {

class StepProgress {
 public:
  explicit StepProgress(Progress listener) : m_listener(forThreads(std::move(listener))) {}

  void expect(double steps) { m_total += steps; }
  /// Reports a finished step of this length. Throws Cancelled.
  void finish(double steps = 1);
  /// Returns a progress for use within steps; it adds nothing. May be called often, by any thread.
  [[nodiscard]] Progress within();
  /// Returns the progress of one step of this length; it advances while the step does.
  [[nodiscard]] Progress of(double steps);

 private:
  [[nodiscard]] bool tell(double within) const;

  Progress m_listener;
  double m_total = 0;
  std::atomic<double> m_done = 0;
};

}  // namespace hogelscope
