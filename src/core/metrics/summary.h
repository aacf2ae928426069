// SPDX-License-Identifier: BSD-3-Clause
// Means of a report's rows, for each test light field and overall: summary.csv, bd.csv.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/metrics/bd_rate.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

/// Means of rows. Each kind of mean has its own name (docs/formulas.md, Metrics). Rows with a
/// problem are excluded, and the mean of nothing is NaN.
struct ReportSummary {
  std::vector<double> means;     ///< of MetricSet::means()
  std::vector<double> weighted;  ///< weighted by the rows' weights
  /// The rows of the lowest finite PSNRs: over the seen pixels, and over the whole frame.
  std::optional<std::size_t> worst;
  std::optional<std::size_t> worstFrame;
  std::size_t identical = 0;
  std::size_t withoutView = 0;  ///< rows with a problem
};

ReportSummary summariseRows(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Means of a test with their intervals, in the order of MetricSet::means().
struct MeansOfTest {
  const std::vector<double>& values;
  std::span<const Interval> intervals;
};

/// A block of summary.csv.
struct TestSummary {
  std::string test;  ///< "all tests" for the last block
  std::vector<ReportRow> rows;
  ReportSummary summary;
  /// 95 % intervals of the means, then of the weighted means.
  std::vector<Interval> intervals;
  std::optional<double> rate;  ///< bits per directional pixel, of a light field in time per frame
  std::optional<double> kilobits{};  ///< in a second, of a light field in time

  [[nodiscard]] bool hasWeights() const;  ///< whether weighted means are others than plain ones
  [[nodiscard]] MeansOfTest means(bool isWeighted) const;
};

/// A test light field's bits per directional pixel, and frame.
struct TestRate {
  std::string test;
  double rate = 0;
};

/// Test light fields that form one rate-distortion curve.
struct RateGroup {
  std::string name;
  std::vector<TestRate> tests;
};

/// A group compared with an earlier one, by one of the means that are qualities.
struct BdRow {
  std::string anchor;
  std::string group;
  MetricMean quality;
  BdDelta delta;
  bool isWeighted = false;  ///< of the means weighted by the states' weights
  /// 95 % intervals of both deltas, over the same draws of states for all tests. Draws without a
  /// delta are left out.
  Interval rate{unknownFigure, unknownFigure};
  Interval gain{unknownFigure, unknownFigure};
};

/// Returns the tests of a report's rows, in their order.
std::vector<std::string> testsOf(const std::vector<ReportRow>& rows);

/// Returns a block for each test in the order of the rows, then one over all tests, whose intervals
/// resample states: rows of one state stay together.
std::vector<TestSummary> summariseTests(const std::vector<ReportRow>& rows,
                                        const MetricSet& metrics,
                                        const std::vector<RateGroup>& groups = {});

/// Compares every group with each earlier one by each mean that is a quality, those over seen
/// pixels first; with weights, by the weighted means first, then by the plain ones. An error that
/// falls with the rate (MetricMean::mayFall) is compared as a quality: a gain below 0 is a better
/// one.
std::vector<BdRow> bdRows(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                          const std::vector<RateGroup>& groups);

/// Returns `summary.csv`; the next function returns `bd.csv`.
std::string summaryCsv(const std::vector<TestSummary>& summaries, const MetricSet& metrics);
std::string bdCsv(const std::vector<BdRow>& rows);

}  // namespace hogelscope
