// SPDX-License-Identifier: BSD-3-Clause
// Points of a report's views in plots.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/report_rows.h"
#include "core/panel/display.h"

namespace hogelscope {

/// The kind of a view's point in a plot.
enum class PlotKind { identical, none, compared };
struct ViewPoint {
  std::size_t row = 0;
  Vec3 eye;  ///< in the display frame, metres
  double psnr = 0;
  PlotKind kind = PlotKind::compared;
};
/// Returns the points of one test, in PlotKind's order with the lowest PSNR last, so that it is
/// drawn on top.
std::vector<ViewPoint> pointsOf(const std::vector<ReportRow>& rows, const std::string& test,
                                const DisplayParams& display);

/// Returns the tooltip of a point.
std::string titleOf(const ViewPoint& point, const ReportRow& row);
/// Returns the radius of points, smaller for many points.
double radiusFor(std::size_t points);

}  // namespace hogelscope
