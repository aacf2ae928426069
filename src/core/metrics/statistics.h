// SPDX-License-Identifier: BSD-3-Clause
// Statistics: confidence intervals of means over views (the bootstrap), rank correlation, and the
// luma histogram of an image.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/optics/image.h"

namespace hogelscope {

/// The value of a figure that is not known.
inline constexpr double unknownFigure = std::numeric_limits<double>::quiet_NaN();

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

/// A group that was drawn: its number, and the sums over units that were drawn of it.
struct DrawnGroup {
  std::size_t group = 0;
  std::vector<double> sums;
};

/// Computes the bootstrap of two levels: draws as many groups as there are, with replacement, then
/// of each as many units as it has, and computes the figures of these groups. For the rest as
/// bootstrap().
std::vector<Interval> nestedBootstrap(
    const std::vector<std::vector<std::vector<double>>>& groups,
    const std::function<std::vector<double>(const std::vector<DrawnGroup>&)>& figures,
    const BootstrapParams& params);

/// Returns the two-sided probability of signs as unequal as those of the differences if both signs
/// are as probable: the sign test. Zeros and NaN do not count; NaN if nothing does.
double signTest(const std::vector<double>& differences);

/// Returns the two-sided probability of Wilcoxon's signed-rank test, from the exact distribution of
/// the sum of ranks, which equal values share. Zeros and NaN do not count; NaN if nothing does.
double signedRankTest(const std::vector<double>& differences);

/// Returns the rank of each value, 1 for the least; equal values share the mean of their ranks.
/// No value may be NaN.
std::vector<double> ranksOf(const std::vector<double>& values);

/// Returns Pearson's correlation; NaN for fewer than two pairs, or if all values of one list are
/// equal. No value may be NaN. Throws std::invalid_argument if the sizes differ.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

/// Returns Spearman's ρ, Pearson's correlation of the ranks, over the pairs without NaN. NaN for
/// fewer than two pairs, or if all values of one list are equal. Throws std::invalid_argument if
/// the sizes differ.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b);

/// The inverse of the normal distribution's Φ, by bisection: Φ(x) = share.
double normalQuantile(double share);

/// Returns the 95 % interval of a share, of which so many of a sample are (Wilson, JASA 22, 1927);
/// 0 … 1 for no sample.
Interval shareInterval(std::size_t passed, std::size_t count);

/// Returns the value below which so many percent of the values lie, interpolated linearly between
/// their ranks as by numpy.percentile; NaN for none.
double percentile(std::vector<double> values, double percent);

/// Pixel counts by luma, 0 … 255.
using Histogram = std::array<std::size_t, 256>;

/// Counts the seen pixels by their luma (BT.709), rounded half up.
Histogram lumaHistogram(const Image& image);
/// Returns the mean luma; NaN if nothing was counted.
double meanOf(const Histogram& counts);
/// Returns the least luma that at least the share of the pixels, 0 … 1, do not exceed.
int quantileOf(const Histogram& counts, double share);

}  // namespace hogelscope
