// SPDX-License-Identifier: BSD-3-Clause
// What the report's plots are made of: axes, ticks and marks as SVG text. Lengths are SVG units.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/axis.h"
#include "core/metrics/report_rows.h"
#include "core/optics/display.h"

namespace hogelscope {

/// A number with two digits after the point, as coordinates need.
std::string coordinate(double value);
/// `anchor`: start, middle, end.
std::string svgText(double x, double y, std::string_view anchor, const std::string& text);
std::string svgLine(double x1, double y1, double x2, double y2, std::string_view style);
/// Grid, ticks, frame and titles around the area of the two axes; linear ticks where none are
/// given.
std::string plotFrame(const Axis& across, const Axis& up, const std::string& titleAcross,
                      const std::string& titleUp, std::vector<Tick> ticksAcross = {});

/// A mark of the k-th of several series: an element with its `attributes` and `content`.
std::string seriesMark(std::size_t series, double x, double y, double radius,
                       const std::string& attributes, const std::string& content);
/// The names of all series beside their marks.
std::string plotLegend(const std::vector<std::string>& names);

/// What there is to say of a view at its place in a plot.
enum class PlotKind { identical, none, compared };
struct PlotPoint {
  const ReportRow* row = nullptr;
  Vec3 eye;  ///< in the display frame, metres
  double psnr = 0;
  PlotKind kind = PlotKind::compared;
};
/// Of one test, in PlotKind's order and the lowest PSNR last, so that nothing covers it.
std::vector<PlotPoint> pointsOf(const std::vector<ReportRow>& rows, const std::string& test,
                                const DisplayParams& display);

/// `<title>`: what a browser shows at a point.
std::string titleOf(const PlotPoint& point);
/// Smaller where there are many.
double radiusFor(std::size_t points);

}  // namespace hogelscope
