// SPDX-License-Identifier: BSD-3-Clause
// What a report's rows amount to, for each test light field and over all: summary.csv, bd.csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/metrics/bd_rate.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

/// What summary.csv calls the means, in the order of ReportMeans.
const std::array<const char*, 5>& figureNames();

/// One block of summary.csv.
struct TestSummary {
  std::string test;  ///< "all tests" for the last block
  std::vector<ReportRow> rows;
  ReportSummary summary;
  /// 95 % intervals of the means in the order of figureNames, then of the weighted ones.
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

/// A group against the first one, in one of the mean PSNRs.
struct BdRow {
  std::string anchor;
  std::string group;
  std::string quality;
  BdDelta delta;
};

/// The tests of a report's rows, in their order.
std::vector<std::string> testsOf(const std::vector<ReportRow>& rows);

/// A block for each test in the order of the rows, then one over all, whose intervals resample
/// states: rows of one state stay together.
std::vector<TestSummary> summariseTests(const std::vector<ReportRow>& rows,
                                        const std::vector<RateGroup>& groups = {});

/// Every later group against the first, in mean_psnr, mean_psnr_y and mean_psnr_yuv.
std::vector<BdRow> bdRows(const std::vector<TestSummary>& summaries,
                          const std::vector<RateGroup>& groups);

/// `summary.csv`, `bd.csv`.
std::string summaryCsv(const std::vector<TestSummary>& summaries);
std::string bdCsv(const std::vector<BdRow>& rows);

}  // namespace hogelscope
