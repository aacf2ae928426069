// SPDX-License-Identifier: BSD-3-Clause
// PSNR over the horizontal viewing angle, one series for each test.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/colour_map.h"
#include "core/metrics/summary.h"
#include "report/page/html.h"
#include "report/page/plot.h"
#include "report/page/report_plots.h"

namespace hogelscope {

namespace {

struct Series {
  std::string test;
  std::vector<PlotPoint> points;  ///< without those that compare nothing
};

double angleOf(const Vec3& eye) {
  return std::atan2(eye.x, eye.z) * 180 / std::numbers::pi;
}

std::vector<Series> seriesOf(const std::vector<ReportRow>& rows, const DisplayParams& display) {
  std::vector<Series> all;
  for (const std::string& test : testsOf(rows)) {
    all.push_back({test, pointsOf(rows, test, display)});
    std::erase_if(all.back().points,
                  [](const PlotPoint& point) { return point.kind == PlotKind::none; });
  }
  return all;
}

/// Both axes out to where the points are; identical views lie in a strip of their own above.
struct Area {
  Axis across{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 62,
              744};
  Axis up{across.low, across.high, 290, 14};
  std::size_t tests = 0;
  bool hasNumbers = false;
  bool hasIdentical = false;

  explicit Area(const std::vector<Series>& all) : tests(all.size()) {
    for (const Series& series : all)
      for (const PlotPoint& point : series.points) add(point);
    pad(across, 2);
    pad(up, 1);
    if (hasIdentical) up.to += 28;
  }

  /// Where the identical views of a series lie: side by side, since all tests share the eyes.
  [[nodiscard]] double stripOf(std::size_t index) const {
    return 12 + 24 * (double(index) + 0.5) / double(tests);
  }

  void add(const PlotPoint& point) {
    across.low = std::min(across.low, angleOf(point.eye));
    across.high = std::max(across.high, angleOf(point.eye));
    if (point.kind == PlotKind::identical) {
      hasIdentical = true;
      return;
    }
    hasNumbers = true;
    up.low = std::min(up.low, point.psnr);
    up.high = std::max(up.high, point.psnr);
  }

  static void pad(Axis& axis, double least) {
    if (!(axis.low <= axis.high)) axis.low = axis.high = 0;
    const double by = std::max(0.05 * (axis.high - axis.low), least - (axis.high - axis.low) / 2);
    axis.low -= by;
    axis.high += by;
  }
};

std::string drawn(const Area& area, const Series& series, std::size_t index) {
  const std::string colour = seriesColour(index);
  std::string text = "<g class=\"points\" fill=\"" + colour + "\" color=\"" + colour + "\">\n";
  for (const PlotPoint& point : series.points) {
    const bool isIdentical = point.kind == PlotKind::identical;
    text += seriesMark(index, area.across.at(angleOf(point.eye)),
                       isIdentical ? area.stripOf(index) : area.up.at(point.psnr),
                       0.8 * radiusFor(series.points.size()), isIdentical ? "class=\"hollow\"" : "",
                       titleOf(point)) +
            "\n";
  }
  return text + "</g>\n";
}

}  // namespace

std::string anglePlot(const std::vector<ReportRow>& rows, const DisplayParams& display) {
  const std::vector<Series> all = seriesOf(rows, display);
  const Area area(all);
  if (!area.hasNumbers) return {};
  std::string text =
      "<figure><svg class=\"wide\" viewBox=\"0 0 760 334\" role=\"img\" aria-label=\"PSNR over "
      "viewing angle\">" +
      plotFrame(area.across, area.up, "horizontal viewing angle in degrees, to the viewer's right",
                "PSNR in dB");
  if (area.hasIdentical) text += svgText(56, 28, "end", "identical");
  for (std::size_t k = 0; k < all.size(); ++k) text += drawn(area, all[k], k);
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Series& series : all) names.push_back(series.test);
  return text + "</svg>\n" + plotLegend(names) + "</figure>\n";
}

}  // namespace hogelscope
