// SPDX-License-Identifier: BSD-3-Clause
// How far a mean over some views can be trusted: the bootstrap.
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

/// 10000, but where that would draw more than 20 million units as many fewer, at least 1000: with
/// thousands of units an interval is narrow, and its own error a few per cent of it.
int resamplesFor(std::size_t units);

/// Figures from the sums over a sample's units; as many for every sample.
using FiguresOfSums = std::function<std::vector<double>(const std::vector<double>& sums)>;

/// Efron's percentile bootstrap: draws as many units as there are, with replacement, adds them up
/// and asks for the figures. An interval reaches from the (1 − c)/2 quantile of a figure to the (1
/// + c)/2 one, both values that were drawn (the ⌈qn⌉-th of n). Draws where a figure is not a number
/// do not count for it; with none left its interval is not a number. Every unit has as many values
/// as the others. The same for the same seed everywhere: std::mt19937_64 and Lemire's unbiased
/// bounded integers.
std::vector<Interval> bootstrap(const std::vector<std::vector<double>>& units,
                                const FiguresOfSums& figures, const BootstrapParams& params = {});

}  // namespace hogelscope
