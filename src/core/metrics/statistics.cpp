// SPDX-License-Identifier: BSD-3-Clause
// The percentile bootstrap.
#include "core/metrics/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// In [0, count). Lemire, "Fast Random Integer Generation in an Interval", 2019.
std::uint32_t below(std::uint32_t count, std::mt19937_64& engine) {
  const std::uint32_t unfair = (0U - count) % count;
  for (;;) {
    const std::uint64_t product = (engine() >> 32) * count;
    if (static_cast<std::uint32_t>(product) >= unfair)
      return static_cast<std::uint32_t>(product >> 32);
  }
}

MULTIVERSIONED
void add(const double* __restrict unit, std::size_t count, double* __restrict sums) {
  for (std::size_t k = 0; k < count; ++k) sums[k] += unit[k];
}

/// The ⌈qn⌉-th smallest value.
double quantile(std::vector<double>& values, double q) {
  const double rank = std::ceil(q * double(values.size()) - 1e-9);  // 0.975 · 10000 is a bit more
  const auto at = values.begin() + std::ptrdiff_t(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Interval interval(std::vector<double>& values, double confidence) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {nothing, nothing};
  return {quantile(values, (1 - confidence) / 2), quantile(values, (1 + confidence) / 2)};
}

}  // namespace

std::vector<Interval> bootstrap(const std::vector<std::vector<double>>& units,
                                const FiguresOfSums& figures, const BootstrapParams& params) {
  const std::size_t width = units.empty() ? 0 : units.front().size();
  std::vector<double> sums(width, 0);
  std::vector<std::vector<double>> drawn;
  std::mt19937_64 engine(params.seed);
  for (int resample = 0; resample < params.resamples; ++resample) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t k = 0; k < units.size(); ++k)
      add(units[below(std::uint32_t(units.size()), engine)].data(), width, sums.data());
    const std::vector<double> values = figures(sums);
    drawn.resize(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) drawn[k].push_back(values[k]);
  }
  std::vector<Interval> intervals;
  intervals.reserve(drawn.size());
  for (std::vector<double>& values : drawn)
    intervals.push_back(interval(values, params.confidence));
  return intervals;
}

}  // namespace hogelscope
