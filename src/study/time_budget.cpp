// SPDX-License-Identifier: BSD-3-Clause
#include "study/time_budget.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>

namespace hogelscope {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

namespace {

/// Plans the first `views` views.
TimePlan shareOut(const std::vector<std::vector<double>>& costs, std::size_t views,
                  double seconds) {
  const std::size_t count = costs.size();
  std::vector<double> run(count);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = 0; k < count; ++k)
    run[k] = std::accumulate(costs[k].begin(), costs[k].begin() + std::ptrdiff_t(views), 0.0);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return run[k]; });
  TimePlan plan{std::vector<bool>(count), std::vector<int>(count, 1), views};
  std::size_t left = count;
  for (const std::size_t k : order) {
    const double part = seconds / double(left--);
    plan.repeats[k] = leastRuns * run[k] <= part;
    if (plan.repeats[k]) {
      seconds -= leastRuns * run[k];
      continue;
    }
    int& divisor = plan.divisors[k];
    while (divisor < coarsestTime && run[k] > part * divisor * divisor) divisor *= 2;
    seconds -= run[k] / (divisor * divisor);
  }
  return plan;
}

}  // namespace

TimePlan planTimes(const std::vector<std::vector<double>>& costs, double seconds) {
  for (std::size_t views = costs.front().size();; views = (views + 1) / 2) {
    TimePlan plan = shareOut(costs, views, seconds);
    const auto count = std::size_t(std::ranges::count(plan.repeats, true));
    if (views == 1 || 4 * count >= 3 * costs.size()) return plan;
  }
}

std::vector<std::size_t> spreadOrder(std::size_t count) {
  std::vector<std::size_t> order;
  for (std::uint64_t k = 0; order.size() < count; ++k) {
    double place = 0;  // van der Corput: the mirrored binary digits of k behind the point
    double digit = 0.5;
    for (std::uint64_t bits = k; bits > 0; bits /= 2, digit /= 2) place += digit * double(bits % 2);
    const auto next = std::size_t(place * double(count));
    if (std::ranges::find(order, next) == order.end()) order.push_back(next);
  }
  return order;
}

}  // namespace hogelscope
