// SPDX-License-Identifier: BSD-3-Clause
// The rows of a report, one for each state and test light field, and their CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/metrics/metric.h"

namespace hogelscope {

struct ReportRow {
  std::string state;
  std::string test;
  std::vector<double> values;  ///< of MetricSet::columns()
  Vec3 eye;                    ///< in the world, metres
  double weight = 1;           ///< weight in the weighted means, at least 0
  std::string problem{};       ///< why nothing can be compared; "" if there is no problem
  std::optional<int> frame{};  ///< of a light field in time
};

/// Returns what texts call a row's view: its state, or "STATE, frame 10".
std::string viewName(const ReportRow& row);

/// A possible `problem`: neither image sees the display.
inline constexpr const char* seesNothing = "sees nothing of the display";

/// Returns `report.csv` (RFC 4180, lines end in \n) with six columns of the standard metrics, and
/// the frame, the last column of both files, where rows have one.
std::string reportCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Returns `metrics.csv`: the columns missing in report.csv, weights and problems.
std::string metricsCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics);

}  // namespace hogelscope
