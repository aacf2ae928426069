// SPDX-License-Identifier: BSD-3-Clause
// Plots that show how the units of a report differ from each other.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "page/figure.h"

namespace hogelscope {

/// Returns the figures units_mean_psnr_seen and units_mean_move_rest, the distribution of the
/// units: each unit's mean over the share of units whose mean is at most as large, with its
/// interval; and yield_mean_psnr_seen and yield_mean_move_rest: the share of units that have at
/// least a PSNR, at most a move, with its interval (shareInterval()). Means are weighted where
/// states have weights. Empty for fewer than two units.
std::vector<Figure> unitFigures(const std::vector<TestSummary>& summaries,
                                const MetricSet& metrics);

/// Returns for each of these means a sentence on what half and 95 % of the units have.
std::vector<std::string> unitSentences(const std::vector<TestSummary>& summaries,
                                       const MetricSet& metrics);

}  // namespace hogelscope
