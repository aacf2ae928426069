// SPDX-License-Identifier: BSD-3-Clause
// PSNR over camera position, as SVG within the report's page.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "core/optics/display.h"

namespace hogelscope {

/// For each test the eyes from above and from the front, in the display frame and at one scale,
/// coloured by PSNR; hollow where the view is identical, a cross where there is none to compare.
std::string cameraMaps(const std::vector<ReportRow>& rows, const DisplayParams& display);

/// PSNR over the eye's horizontal angle, atan2(x, z) in the display frame, one series for each
/// test. Empty where no PSNR is finite.
std::string anglePlot(const std::vector<ReportRow>& rows, const DisplayParams& display);

/// Rate–distortion: each headline quality over bits per directional pixel, a curve for each group,
/// with the 95 % intervals of the means. Empty without groups.
std::string ratePlots(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                      const std::vector<RateGroup>& groups);

/// The false colours upright with their values, [low, high]; `unit` stands above.
std::string colourBar(double low, double high, const std::string& unit);

}  // namespace hogelscope
