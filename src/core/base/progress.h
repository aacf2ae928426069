// SPDX-License-Identifier: BSD-3-Clause
// How long work tells where it stands and hears that it should stop.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"

namespace hogelscope {

/// Takes the done fraction, 0 … 1; returns false to stop. May be empty. Called from any of the
/// threads that do the work, one at a time.
using Progress = std::function<bool(double done)>;

/// Throws Cancelled where the answer is stop.
inline void reportProgress(const Progress& progress, double done) {
  if (progress && !progress(done)) throw Cancelled();
}

/// Only asks, where the work is too fine to say how far it is.
inline void hearStop(const Progress& progress) {
  reportProgress(progress, 0.0);
}

/// The part [from, to] of a longer work.
inline Progress part(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [=](double done) { return whole(from + (to - from) * done); };
}

/// For work that asks often and on several threads at once. The listener hears the farthest that
/// any of them has told, one call at a time and every 20 ms at most; after its first false
/// everybody hears false.
Progress forThreads(Progress listener);

/// "2:05 left", if it goes on as it did so far; "" where too little is done to say.
std::string timeLeft(double secondsSoFar, double done);

}  // namespace hogelscope
