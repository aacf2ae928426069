// SPDX-License-Identifier: BSD-3-Clause
// Twins as tests of a report, with figures beside the metrics of their pictures: how far rays move
// (core/engine/ray_moves).
#pragma once

#include <string>
#include <vector>

#include "core/engine/ray_moves.h"
#include "core/metrics/metric.h"
#include "core/metrics/summary.h"
#include "report/report_request.h"

namespace hogelscope {

/// Makes units the tests of the display as designed: names, and the request's session with a twin.
/// Without any, the unit is the session's own twin. Returns false if that has no errors.
[[nodiscard]] bool compareWithDesign(ReportRequest& request,
                                     const std::vector<std::pair<std::string, Session>>& units);

/// Returns the columns move_rms and move_rest, which are no metric of two pictures: its values are
/// NaN, and moveValues() gives those of a row.
Metric moveMetric();
std::vector<double> moveValues(const RayMoves& moves);

/// Returns a sentence for each test whose rays move alike, so that another place of the eye has the
/// designed view and its PSNR tells no loss. Empty without moveMetric().
std::vector<std::string> harmlessMoves(const std::vector<TestSummary>& summaries,
                                       const MetricSet& metrics);

}  // namespace hogelscope
