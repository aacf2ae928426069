// SPDX-License-Identifier: BSD-3-Clause
// PSNR over the horizontal viewing angle, one series for each test.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/metrics/summary.h"
#include "report/page/html.h"
#include "report/page/plot.h"
#include "report/page/report_plots.h"

namespace hogelscope {

namespace {

/// Okabe and Ito's colours for all kinds of colour vision, without the yellow, which paper loses.
constexpr std::array<const char*, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000"};
/// Corners of the markers other than the circle, in radii.
constexpr std::array<std::array<double, 8>, 4> corners{{{-1, -1, 1, -1, 1, 1, -1, 1},
                                                        {0, -1.2, 1.2, 1, 0, 1, -1.2, 1},
                                                        {0, -1.4, 1.4, 0, 0, 1.4, -1.4, 0},
                                                        {0, 1.2, 1.2, -1, 0, -1, -1.2, -1}}};

struct Series {
  std::string test;
  std::vector<PlotPoint> points;  ///< without those that compare nothing
};

std::string shape(std::size_t series, double x, double y, double radius) {
  const std::size_t kind = series % (corners.size() + 1);
  if (kind == 0)
    return "<circle cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" r=\"" +
           coordinate(radius) + "\"";
  std::string points;
  for (std::size_t k = 0; k < 8; k += 2)
    points += (k == 0 ? "" : " ") + coordinate(x + radius * corners[kind - 1][k]) + "," +
              coordinate(y + radius * corners[kind - 1][k + 1]);
  return "<polygon points=\"" + points + "\"";
}

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
  const std::string colour = colours[index % colours.size()];
  std::string text = "<g class=\"points\" fill=\"" + colour + "\" color=\"" + colour + "\">\n";
  for (const PlotPoint& point : series.points) {
    const bool isIdentical = point.kind == PlotKind::identical;
    text += shape(index, area.across.at(angleOf(point.eye)),
                  isIdentical ? area.stripOf(index) : area.up.at(point.psnr),
                  0.8 * radiusFor(series.points.size()));
    if (isIdentical) text += " class=\"hollow\"";
    text += ">" + titleOf(point) + (shape(index, 0, 0, 1)[1] == 'c' ? "</circle>" : "</polygon>") +
            "\n";
  }
  return text + "</g>\n";
}

std::string legend(const std::vector<Series>& all) {
  std::string text = "<ul class=\"legend\">";
  for (std::size_t k = 0; k < all.size(); ++k)
    text += std::string("<li><svg viewBox=\"-8 -8 16 16\" width=\"14\" height=\"14\" fill=\"") +
            colours[k % colours.size()] + "\" aria-hidden=\"true\">" + shape(k, 0, 0, 5) +
            "/></svg> " + escaped(all[k].test) + "</li>";
  return text + "</ul>\n";
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
  return text + "</svg>\n" + legend(all) + "</figure>\n";
}

}  // namespace hogelscope
