// SPDX-License-Identifier: BSD-3-Clause
// Shares a budget of wall time out among methods that cost very different amounts of it.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace hogelscope {

/// Returns seconds since any moment, never fewer than before.
using Clock = std::function<double()>;
double steadySeconds();

/// The seconds of all pictures of one kind: of those of every n-th band of rows whole + bands / n.
struct PictureCost {
  double whole = 0;
  double bands = 0;
};

/// Which pixels errors are measured on.
struct ErrorPlan {
  std::vector<int> steps;  ///< of each cost: one band of so many
  std::size_t views = 1;
};

/// Returns the plan for the pictures of `views`, the reference's first. While they take more than
/// `seconds`, the costliest ones get half of their bands, down to one of `mostStep`; after that
/// there are fewer views, one at least. No step is below that of the reference, since only its
/// pixels can be compared.
ErrorPlan planErrors(const std::vector<PictureCost>& costs, int mostStep, std::size_t views,
                     double seconds);

/// How often, and on how many pixels, methods are timed.
struct TimePlan {
  std::vector<bool> repeats;
  std::vector<int> divisors;  ///< of a picture's sides, of what is timed once
  std::size_t views = 1;
};

constexpr int leastRuns = 5;
constexpr int mostRuns = 25;
/// Times of still fewer pixels would be those of the threads' start, not of the method.
constexpr int coarsestTime = 4;

/// Returns the plan for methods that take `costs[method][view]` seconds. Each may have an equal
/// part of `seconds`; what cheap ones leave goes to the others. A method whose least runs do not
/// fit into its part is timed once, on the whole picture or the first smaller one that does. Only
/// the first views, one at least, are timed if otherwise less than three quarters of the methods
/// were repeated.
TimePlan planTimes(const std::vector<std::vector<double>>& costs, double seconds);

/// Returns 0 … count - 1 in an order of which every beginning is spread over all.
std::vector<std::size_t> spreadOrder(std::size_t count);

}  // namespace hogelscope
