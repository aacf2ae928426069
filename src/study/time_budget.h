// SPDX-License-Identifier: BSD-3-Clause
// Distribution of a budget of wall time among methods of very different costs.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace hogelscope {

/// Returns monotonic seconds since an arbitrary moment.
using Clock = std::function<double()>;
double steadySeconds();

/// The repetitions and pixels for timing methods.
struct TimePlan {
  std::vector<bool> repeats;
  std::vector<int> divisors;  ///< divisors of an image's sides, for methods timed once
  std::size_t views = 1;
};

constexpr int leastRuns = 5;
constexpr int mostRuns = 25;
/// The largest divisor; with fewer pixels the threads' start would dominate the time.
constexpr int coarsestTime = 4;

/// Plans the timing of methods that take `costs[method][view]` seconds. Each gets an equal part of
/// `seconds`; the rest of cheap ones goes to the others. A method whose minimum number of runs
/// exceeds its part is timed once, on the whole image or the first smaller one that fits. Only the
/// first views, at least one, are timed if otherwise less than three quarters of the methods were
/// repeated.
TimePlan planTimes(const std::vector<std::vector<double>>& costs, double seconds);

/// Returns 0 … count - 1 in an order of which every prefix is spread over the whole range.
std::vector<std::size_t> spreadOrder(std::size_t count);

}  // namespace hogelscope
