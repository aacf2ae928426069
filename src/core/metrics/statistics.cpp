// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

#include "core/base/bisect.h"
#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// Returns an integer in [0, count). Lemire, "Fast Random Integer Generation in an Interval", 2019.
std::uint32_t below(std::uint32_t count, std::mt19937_64& engine) {
  const std::uint32_t unfair = (0U - count) % count;
  for (;;) {
    const std::uint64_t product = (engine() >> 32) * count;
    if (static_cast<std::uint32_t>(product) >= unfair)
      return static_cast<std::uint32_t>(product >> 32);
  }
}

/// The number of resamples drawn per pass over the units, because a pass over many units is limited
/// by memory.
constexpr std::size_t mostAtOnce = 16;

MULTIVERSIONED
void add(const double* __restrict unit, std::size_t count, double times, double* __restrict sums) {
  for (std::size_t k = 0; k < count; ++k) sums[k] += times * unit[k];
}

/// Draws `samples` samples and returns the sums of each.
std::vector<std::vector<double>> drawSums(const std::vector<std::vector<double>>& units,
                                          std::size_t samples, std::mt19937_64& engine) {
  const std::size_t width = units.empty() ? 0 : units.front().size();
  const std::size_t n = units.size();
  std::vector<std::uint32_t> times(n * samples);  // how often a sample contains each unit
  for (std::size_t sample = 0; sample < samples; ++sample)
    for (std::size_t k = 0; k < n; ++k) ++times[sample * n + below(std::uint32_t(n), engine)];
  std::vector<std::vector<double>> sums(samples, std::vector<double>(width));
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t sample = 0; sample < samples; ++sample)
      if (const std::uint32_t count = times[sample * n + k]; count > 0)
        add(units[k].data(), width, count, sums[sample].data());
  return sums;
}

/// Returns the ⌈qn⌉-th smallest value.
double quantile(std::vector<double>& values, double q) {
  const double rank = std::ceil(q * double(values.size()) - 1e-9);  // 0.975 · 10000 is above 9750
  const auto at = values.begin() + std::ptrdiff_t(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Interval interval(std::vector<double>& values, double confidence) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {unknownFigure, unknownFigure};
  return {quantile(values, (1 - confidence) / 2), quantile(values, (1 + confidence) / 2)};
}

/// Adds the figures of a draw to those of the others, figure by figure.
void addTo(std::vector<std::vector<double>>& drawn, const std::vector<double>& figures) {
  drawn.resize(figures.size());
  for (std::size_t k = 0; k < figures.size(); ++k) drawn[k].push_back(figures[k]);
}

std::vector<Interval> intervalsOf(std::vector<std::vector<double>>& drawn, double confidence) {
  std::vector<Interval> intervals;
  intervals.reserve(drawn.size());
  for (std::vector<double>& values : drawn) intervals.push_back(interval(values, confidence));
  return intervals;
}

}  // namespace

int resamplesFor(std::size_t units) {
  constexpr std::size_t most = 10000;
  constexpr std::size_t mostDraws = 20000000;
  return int(std::clamp(mostDraws / std::max(units, std::size_t{1}), most / 10, most));
}

std::vector<Interval> bootstrap(const std::vector<std::vector<double>>& units,
                                const FiguresOfSums& figures, const BootstrapParams& params) {
  std::vector<std::vector<double>> drawn;
  std::mt19937_64 engine(params.seed);
  for (std::size_t left = std::size_t(params.resamples); left > 0;) {
    const std::size_t samples = std::min(left, mostAtOnce);
    left -= samples;
    for (const std::vector<double>& sums : drawSums(units, samples, engine)) {
      addTo(drawn, figures(sums));
    }
  }
  return intervalsOf(drawn, params.confidence);
}

std::vector<Interval> nestedBootstrap(
    const std::vector<std::vector<std::vector<double>>>& groups,
    const std::function<std::vector<double>(const std::vector<DrawnGroup>&)>& figures,
    const BootstrapParams& params) {
  std::vector<std::vector<double>> drawn;
  std::mt19937_64 engine(params.seed);
  for (int sample = 0; sample < params.resamples; ++sample) {
    std::vector<DrawnGroup> groupsDrawn;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const std::size_t group = below(std::uint32_t(groups.size()), engine);
      groupsDrawn.push_back({group, drawSums(groups[group], 1, engine).front()});
    }
    addTo(drawn, figures(groupsDrawn));
  }
  return intervalsOf(drawn, params.confidence);
}

namespace {

/// Returns the values that are neither 0 nor NaN.
std::vector<double> withSign(std::vector<double> differences) {
  std::erase_if(differences, [](double value) { return std::isnan(value) || value == 0; });
  return differences;
}

/// Returns the probability that a sum of weights, each of which counts with the probability 1/2, is
/// at most `least` or at least their whole sum without it.
double twoSided(const std::vector<std::size_t>& weights, std::size_t sum) {
  const std::size_t whole = std::accumulate(weights.begin(), weights.end(), std::size_t{0});
  std::vector<double> probabilities(whole + 1, 0);
  probabilities[0] = 1;
  for (const std::size_t weight : weights)
    for (std::size_t k = whole + 1; k-- > 0;)
      probabilities[k] = 0.5 * (probabilities[k] + (k < weight ? 0 : probabilities[k - weight]));
  double tail = 0;
  for (std::size_t k = 0; k <= std::min(sum, whole - sum); ++k) tail += probabilities[k];
  return std::min(1.0, 2 * tail);
}

}  // namespace

double signTest(const std::vector<double>& differences) {
  const std::vector<double> values = withSign(differences);
  if (values.empty()) return unknownFigure;
  const auto above = std::ranges::count_if(values, [](double value) { return value > 0; });
  return twoSided(std::vector<std::size_t>(values.size(), 1), std::size_t(above));
}

double signedRankTest(const std::vector<double>& differences) {
  const std::vector<double> values = withSign(differences);
  if (values.empty()) return unknownFigure;
  std::vector<double> sizes;
  for (const double value : values) sizes.push_back(std::abs(value));
  std::vector<std::size_t> doubled;  // ranks that are shared end in ½
  std::size_t above = 0;
  const std::vector<double> ranks = ranksOf(sizes);
  for (std::size_t k = 0; k < ranks.size(); ++k) {
    doubled.push_back(std::size_t(std::lround(2 * ranks[k])));
    if (values[k] > 0) above += doubled.back();
  }
  return twoSided(doubled, above);
}

std::vector<double> ranksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return values[k]; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t k = first; k < end; ++k) ranks[order[k]] = 0.5 * double(first + 1 + end);
    first = end;
  }
  return ranks;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) throw std::invalid_argument("correlation: sizes differ");
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  };
  const double meanA = mean(a);
  const double meanB = mean(b);
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - meanA) * (b[k] - meanB);
    aa += (a[k] - meanA) * (a[k] - meanA);
    bb += (b[k] - meanB) * (b[k] - meanB);
  }
  return ab / std::sqrt(aa * bb);  // 0/0 is NaN
}

double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) throw std::invalid_argument("rankCorrelation: sizes differ");
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::isnan(a[k]) || std::isnan(b[k])) continue;
    x.push_back(a[k]);
    y.push_back(b[k]);
  }
  return correlation(ranksOf(x), ranksOf(y));
}

double normalQuantile(double share) {
  const auto isBelow = [share](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)) < share; };
  return bisect({-40, 40}, 80, isBelow).middle();
}

Interval shareInterval(std::size_t passed, std::size_t count) {
  if (count == 0) return {0, 1};
  const auto n = double(count);
  const double z = normalQuantile(0.975);
  const double share = double(passed) / n;
  const double middle = share + z * z / (2 * n);
  const double half = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {(middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n)};
}

double percentile(std::vector<double> values, double percent) {
  if (values.empty()) return unknownFigure;
  std::ranges::sort(values);
  const double rank = percent / 100 * double(values.size() - 1);
  const auto below = std::size_t(rank);
  const double above = values[std::min(below + 1, values.size() - 1)];
  return values[below] + (rank - double(below)) * (above - values[below]);
}

Histogram lumaHistogram(const Image& image) {
  Histogram counts{};
  for (std::size_t k = 0; k < image.pixelCount(); ++k) {
    if (image.seen[k] == 0) continue;
    const std::uint8_t* rgb = &image.rgb[3 * k];
    ++counts[quantised(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2])];
  }
  return counts;
}

double meanOf(const Histogram& counts) {
  double sum = 0;
  double pixels = 0;
  for (std::size_t luma = 0; luma < counts.size(); ++luma) {
    sum += double(luma) * double(counts[luma]);
    pixels += double(counts[luma]);
  }
  return sum / pixels;
}

int quantileOf(const Histogram& counts, double share) {
  const double pixels = std::accumulate(counts.begin(), counts.end(), 0.0);
  double sum = 0;
  int luma = 0;
  for (; luma < 255; ++luma) {
    sum += double(counts[std::size_t(luma)]);
    if (sum >= share * pixels) break;
  }
  return luma;
}

}  // namespace hogelscope
