// SPDX-License-Identifier: BSD-3-Clause
// Progress of work in steps of different length, done on several threads.
#pragma once

#include <chrono>
#include <mutex>

#include "core/progress.h"

namespace hogelscope {

class StepProgress {
 public:
  /// `listener` is called by one thread at a time, some 50 times a second.
  explicit StepProgress(Progress listener) : m_listener(std::move(listener)) {}

  void expect(double steps) { m_total += steps; }
  /// A step of such a length has been done. Throws Cancelled.
  void finish(double steps = 1);
  /// Within steps, which take part in nothing: may be called often, from every thread.
  [[nodiscard]] Progress within();
  /// Of one step: moves on while the step does.
  [[nodiscard]] Progress of(double steps);

 private:
  [[nodiscard]] bool tell(double within);

  Progress m_listener;
  double m_total = 0;
  std::mutex m_mutex;  ///< guards the rest
  double m_done = 0;
  bool m_stops = false;
  std::chrono::steady_clock::time_point m_told{};
};

}  // namespace hogelscope
