// SPDX-License-Identifier: BSD-3-Clause
// Sums over views, from which means follow, and the rate-distortion curves of groups of tests.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/metrics/summary.h"

namespace hogelscope {

/// Returns a row's sums for the means: Σ value and Σ 1 for each mean, then both times its weight.
std::vector<double> sumsOf(const ReportRow& row, const MetricSet& metrics);

/// Returns the means of one or several lists of sums.
std::vector<double> meansOfSums(const std::vector<double>& sums, const MetricSet& metrics);

/// A comparison of two groups by one mean: the indices of their tests in the summaries.
struct BdPair {
  std::size_t anchor = 0;  ///< of the groups
  std::size_t group = 0;
  std::size_t mean = 0;  ///< of the means, or, above their number, of the weighted ones
};

/// The curves of the groups, from the means of all their tests. The summaries must live as long.
class RateCurves {
 public:
  RateCurves(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
             const std::vector<RateGroup>& groups);

  [[nodiscard]] bool haveWeights() const;
  /// Returns the sums of each state, those of all tests side by side. None if a test has not all
  /// states.
  [[nodiscard]] std::vector<std::vector<double>> units() const;
  /// Returns the means of all tests, plain ones and weighted ones.
  [[nodiscard]] std::vector<double> means() const;
  /// Compares by the means of all tests.
  [[nodiscard]] BdDelta deltaOf(const BdPair& pair, const std::vector<double>& means) const;

 private:
  /// A test of a group: its rate, and its number among all tests, if it has a summary.
  struct Place {
    double rate = 0;
    std::optional<std::size_t> test;
  };

  [[nodiscard]] std::vector<RatePoint> curveOf(std::size_t group, std::size_t mean,
                                               const std::vector<double>& means) const;

  const MetricSet& m_metrics;
  std::vector<std::vector<Place>> m_curves;  ///< of each group
  std::vector<const TestSummary*> m_tests;
};

/// Returns the comparisons in the order of bdRows().
std::vector<BdPair> bdPairs(const MetricSet& metrics, std::size_t groups, bool haveWeights);

}  // namespace hogelscope
