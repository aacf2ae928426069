// SPDX-License-Identifier: BSD-3-Clause
// Confidence intervals of means over views: the bootstrap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace hogelscope {

struct Interval {
  double low = 0;
  double high = 0;
};

struct BootstrapParams {
  int resamples = 10000;
  double confidence = 0.95;
  std::uint64_t seed = 1;
};

/// Returns 10000, or fewer (at least 1000) where these would draw more than 20 million units. With
/// thousands of units an interval is narrow, and its own error is a few per cent of its width.
int resamplesFor(std::size_t units);

/// Returns figures of the sums over a sample's units, always the same number of them.
using FiguresOfSums = std::function<std::vector<double>(const std::vector<double>& sums)>;

/// Computes Efron's percentile bootstrap: draws as many units as there are, with replacement, adds
/// them and computes the figures. An interval reaches from the (1 − c)/2 to the (1 + c)/2 quantile
/// of a figure, both drawn values (the ⌈qn⌉-th of n). NaN figures are excluded; if none remain, the
/// interval is NaN. All units have the same number of values. The result is the same for the same
/// seed on every machine: std::mt19937_64 and Lemire's unbiased bounded integers.
std::vector<Interval> bootstrap(const std::vector<std::vector<double>>& units,
                                const FiguresOfSums& figures, const BootstrapParams& params = {});

}  // namespace hogelscope
