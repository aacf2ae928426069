// SPDX-License-Identifier: BSD-3-Clause
// The views of a report at their places in plots.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/report_rows.h"
#include "core/optics/display.h"

namespace hogelscope {

/// What there is to say of a view at its place in a plot.
enum class PlotKind { identical, none, compared };
struct ViewPoint {
  std::size_t row = 0;
  Vec3 eye;  ///< in the display frame, metres
  double psnr = 0;
  PlotKind kind = PlotKind::compared;
};
/// Of one test, in PlotKind's order and the lowest PSNR last, so that nothing covers it.
std::vector<ViewPoint> pointsOf(const std::vector<ReportRow>& rows, const std::string& test,
                                const DisplayParams& display);

/// What a browser shows at a point.
std::string titleOf(const ViewPoint& point, const ReportRow& row);
/// Smaller where there are many.
double radiusFor(std::size_t points);

}  // namespace hogelscope
