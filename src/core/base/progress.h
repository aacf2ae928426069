// SPDX-License-Identifier: BSD-3-Clause
// Progress reporting and cancellation.
#pragma once

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

}  // namespace hogelscope
