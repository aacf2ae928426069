// SPDX-License-Identifier: BSD-3-Clause
// PSNR over the horizontal viewing angle or the states, one series for each test.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/metrics/summary.h"
#include "page/plot.h"
#include "report/page/report_plots.h"
#include "report/page/view_points.h"

namespace hogelscope {

namespace {

double angleOf(const Vec3& eye) {
  return std::atan2(eye.x, eye.z) * 180 / std::numbers::pi;
}

}  // namespace

Plot psnrPlot(const std::vector<ReportRow>& rows, const DisplayParams& display, bool isOverAngle) {
  const std::vector<std::string> tests = testsOf(rows);
  Plot plot;
  plot.titleAcross =
      isOverAngle ? "horizontal viewing angle in degrees, to the viewer's right" : "state";
  plot.titleUp = "PSNR in dB";
  plot.leastRange = {2, 1};
  for (const std::string& test : tests) {
    Plot::Series& series = plot.series.emplace_back(Plot::Series{test, {}});
    for (const ViewPoint& point : pointsOf(rows, test, display)) {
      if (point.kind == PlotKind::none) continue;
      const double state = 1 + double(point.row / tests.size());
      series.points.push_back({isOverAngle ? angleOf(point.eye) : state, point.psnr,
                               titleOf(point, rows[point.row]), point.row});
    }
    series.radius = 0.8 * radiusFor(series.points.size());
  }
  return plot;
}

std::string anglePlot(const std::vector<ReportRow>& rows, const DisplayParams& display) {
  const Plot plot = psnrPlot(rows, display, true);
  const bool hasNumbers = std::ranges::any_of(plot.series, [](const Plot::Series& series) {
    return std::ranges::any_of(series.points,
                               [](const Plot::Point& point) { return std::isfinite(point.up); });
  });
  if (!hasNumbers) return {};
  return "<figure>" + svgOf(plot, {760, 334}, "wide", "PSNR over viewing angle") + legendOf(plot) +
         "</figure>\n";
}

}  // namespace hogelscope
