// SPDX-License-Identifier: BSD-3-Clause
// Progress reporting and cancellation.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "core/base/error.h"

namespace hogelscope {

/// Receives the fraction done, 0 … 1; returns false to cancel. May be empty. Called from any
/// working thread, never concurrently.
using Progress = std::function<bool(double done)>;

/// Calls `progress` and throws Cancelled if it returns false.
inline void reportProgress(const Progress& progress, double done) {
  if (progress && !progress(done)) throw Cancelled();
}

/// Throws Cancelled likewise, without reporting a fraction; for steps too small to measure.
inline void throwIfCancelled(const Progress& progress) {
  reportProgress(progress, 0.0);
}

/// Returns the progress of the part [from, to] of a longer job.
inline Progress part(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [=](double done) { return whole(from + (to - from) * done); };
}

/// Returns a progress for frequent calls from several threads at once. It calls the listener with
/// the largest fraction so far, never concurrently and at most every 20 ms; once the listener has
/// returned false, every call returns false.
Progress forThreads(Progress listener);

/// Returns "2:05 left", extrapolated from the time so far; "" if too little is done.
std::string timeLeft(double secondsSoFar, double done);

/// Progress of work in steps of different length on several threads.
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
