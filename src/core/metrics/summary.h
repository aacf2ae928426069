// SPDX-License-Identifier: BSD-3-Clause
// Means of a report's rows, for each test light field and over all: summary.csv, bd.csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/metrics/bd_rate.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

/// Means are named, never mixed (docs/formulas.md, Metrics). A row with a problem counts in none,
/// and the mean of nothing is NaN.
struct ReportSummary {
  std::vector<double> means;     ///< of MetricSet::means()
  std::vector<double> weighted;  ///< the same, with each row's weight
  /// The rows of the lowest PSNRs that are not infinite: over what is seen, over the whole frame.
  std::optional<std::size_t> worst;
  std::optional<std::size_t> worstFrame;
  std::size_t identical = 0;
  std::size_t withoutView = 0;  ///< rows with a problem
};

ReportSummary summariseRows(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// One block of summary.csv.
struct TestSummary {
  std::string test;  ///< "all tests" for the last block
  std::vector<ReportRow> rows;
  ReportSummary summary;
  /// 95 % intervals of the means, then of the weighted means.
  std::vector<Interval> intervals;
  std::optional<double> rate;  ///< bits per directional pixel
};

/// A test light field's bits per directional pixel.
struct TestRate {
  std::string test;
  double rate = 0;
};

/// Test light fields that make one rate-distortion curve.
struct RateGroup {
  std::string name;
  std::vector<TestRate> tests;
};

/// A group against the first one, in one of the means that are qualities.
struct BdRow {
  std::string anchor;
  std::string group;
  MetricMean quality;
  BdDelta delta;
};

/// The tests of a report's rows, in their order.
std::vector<std::string> testsOf(const std::vector<ReportRow>& rows);

/// A block for each test in the order of the rows, then one over all, whose intervals resample
/// states: rows of one state stay together.
std::vector<TestSummary> summariseTests(const std::vector<ReportRow>& rows,
                                        const MetricSet& metrics,
                                        const std::vector<RateGroup>& groups = {});

/// Compares every later group with the first, in each mean that is a quality, those over what is
/// seen first.
std::vector<BdRow> bdRows(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                          const std::vector<RateGroup>& groups);

/// `summary.csv`, `bd.csv`.
std::string summaryCsv(const std::vector<TestSummary>& summaries, const MetricSet& metrics);
std::string bdCsv(const std::vector<BdRow>& rows);

}  // namespace hogelscope
