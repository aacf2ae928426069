// SPDX-License-Identifier: BSD-3-Clause
// The plots of a report.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "core/optics/display.h"
#include "page/plot.h"

namespace hogelscope {

/// For each test the eyes from above and from the front, in the display frame and at one scale,
/// coloured by PSNR; hollow where the view is identical, a cross where there is none to compare.
std::string cameraMaps(const std::vector<ReportRow>& rows, const DisplayParams& display);

/// PSNR of each row over the eye's horizontal angle, atan2(x, z) in the display frame, or over the
/// number of its state, from 1; one series for each test. Rows are in ReportOrder; those with a
/// problem have no point.
Plot psnrPlot(const std::vector<ReportRow>& rows, const DisplayParams& display, bool isOverAngle);
/// The first of both for the page. Empty where no PSNR is finite.
std::string anglePlot(const std::vector<ReportRow>& rows, const DisplayParams& display);

/// Rate–distortion: each headline quality over bits per directional pixel, a curve for each group,
/// with the 95 % intervals of the means. Empty without groups.
std::string ratePlots(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                      const std::vector<RateGroup>& groups);

/// The false colours upright with their values, [low, high]; `unit` stands above.
std::string colourBar(double low, double high, const std::string& unit);

}  // namespace hogelscope
