// SPDX-License-Identifier: BSD-3-Clause
// The rows of a report, one for each state and test light field, as CSV. Last on the line.
#pragma once

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
  double weight = 1;           ///< in the weighted means, 0 or more
  std::string problem{};       ///< why there is nothing to compare; "" if there is
};

/// A `problem`: neither image sees the display.
inline constexpr const char* seesNothing = "sees nothing of the display";

/// Returns `report.csv`, RFC 4180, lines end in \n: six columns of the standard metrics.
std::string reportCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Returns `metrics.csv`: the columns that report.csv does not have, weights and problems.
std::string metricsCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics);

}  // namespace hogelscope
