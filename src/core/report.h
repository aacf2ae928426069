// SPDX-License-Identifier: BSD-3-Clause
// The report: one row for each state and test light field. Last on the line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/metrics.h"

namespace hogelscope {

struct ReportRow {
  std::string state;
  std::string test;
  Metrics metrics;
  Vec3 eye;  ///< in the world, metres
};

/// Averages are named, never mixed (DESIGN §2). Means of nothing are not numbers.
struct ReportSummary {
  double meanFinitePsnr = 0;
  double psnrOfMeanMse = 0;
  std::optional<std::size_t> worst;  ///< row of the lowest PSNR
  std::size_t identical = 0;
};

ReportSummary summarise(const std::vector<ReportRow>& rows);

/// The shortest text that reads back as the same number; "inf", "nan".
std::string numberText(double value);

/// A text as a cell of a CSV file (RFC 4180).
std::string csvCell(const std::string& text);

/// `report.csv` (DESIGN §5), RFC 4180, lines end in \n.
std::string csv(const std::vector<ReportRow>& rows);

}  // namespace hogelscope
