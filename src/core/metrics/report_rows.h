// SPDX-License-Identifier: BSD-3-Clause
// The report: one row for each state and test light field. Last on the line.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/metrics/metrics.h"

namespace hogelscope {

struct ReportRow {
  std::string state;
  std::string test;
  Metrics metrics;
  Vec3 eye;               ///< in the world, metres
  double weight = 1;      ///< in the weighted means, 0 or more
  std::string problem{};  ///< why there is nothing to compare; "" if there is
};

/// A `problem`: neither picture sees the display.
inline constexpr const char* seesNothing = "sees nothing of the display";

/// Averages are named, never mixed (docs/formulas.md, Metrics). Infinite PSNRs do not count in
/// means of PSNRs, and neither what is not a number nor a row with a problem counts anywhere. Means
/// of nothing are not numbers.
struct ReportMeans {
  double meanFinitePsnr = 0;
  double psnrOfMeanMse = 0;
  double meanSsim = 0;
  double meanPsnrY = 0;
  double meanPsnrYuv = 0;
};

struct ReportSummary : ReportMeans {
  ReportMeans weighted;
  std::optional<std::size_t> worst;  ///< row of the lowest PSNR
  std::size_t identical = 0;
  std::size_t withoutView = 0;  ///< rows with a problem; they count nowhere else
};

/// Sums from which the means follow: for each figure Σ weight · value, Σ weight.
using MeanSums = std::array<double, 10>;
MeanSums meanSums(const ReportRow& row, double weight);
ReportMeans meansOf(const double* sums);  ///< of a MeanSums

ReportSummary summarise(const std::vector<ReportRow>& rows);

/// `report.csv`, RFC 4180, lines end in \n.
std::string csv(const std::vector<ReportRow>& rows);

/// `metrics.csv`: what report.csv, whose columns are fixed, does not hold.
std::string metricsCsv(const std::vector<ReportRow>& rows);

}  // namespace hogelscope
