// SPDX-License-Identifier: BSD-3-Clause
// The plots of a report.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "core/panel/display.h"
#include "page/plot.h"

namespace hogelscope {

/// Returns two maps for each test, with the eyes from above and from the front, in the display
/// frame at equal scale, coloured by PSNR; hollow for identical views, a cross without a
/// comparison.
std::string cameraMaps(const std::vector<ReportRow>& rows, const DisplayParams& display);

/// Returns a plot of each row's PSNR over the eye's horizontal angle, atan2(x, z) in the display
/// frame, or over the number of its state, from 1; one series for each test. Rows are in
/// ReportOrder; those with a problem have no point.
Plot psnrPlot(const std::vector<ReportRow>& rows, const DisplayParams& display, bool isOverAngle);
/// Returns the plot over the angle for the page; empty if no PSNR is finite.
std::string anglePlot(const std::vector<ReportRow>& rows, const DisplayParams& display);

/// Returns rate–distortion plots: each headline quality over bits per directional pixel, one curve
/// for each group, with the 95 % intervals of the means. Empty without groups.
std::string ratePlots(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                      const std::vector<RateGroup>& groups);

/// Returns an upright scale of the false colours for [low, high], with `unit` above.
std::string colourBar(double low, double high, const std::string& unit);

}  // namespace hogelscope
