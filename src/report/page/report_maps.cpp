// SPDX-License-Identifier: BSD-3-Clause
// PSNR over camera position, from above and from the front.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/colour_map.h"
#include "core/metrics/summary.h"
#include "page/html.h"
#include "page/plot.h"
#include "report/page/report_plots.h"
#include "report/page/view_points.h"

namespace hogelscope {

namespace {

constexpr double mapLeft = 62;
constexpr double mapWidth = 300;
constexpr double mapTop = 26;

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double width() const { return high - low; }
  void widen(double by) {
    low -= by / 2;
    high += by / 2;
  }
};

std::string colourOf(double share) {
  const auto [r, g, b] = falseColour(share);
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned{r}, unsigned{g}, unsigned{b});
  return text.data();
}

/// Returns the range of the finite PSNRs of all tests, extended to round numbers; low > high if
/// there are none.
Span psnrSpan(const std::vector<ReportRow>& rows) {
  Span range;
  for (const ReportRow& row : rows) {
    const double db = row.values[psnrSeenColumn];
    if (row.problem.empty() && std::isfinite(db)) range.add(db);
  }
  if (!(range.low <= range.high)) return range;
  if (range.width() < 1) range.widen(1 - range.width());
  const double step = tickStep(range.width(), 6);
  return {step * std::floor(range.low / step), step * std::ceil(range.high / step)};
}

std::string mark(const ViewPoint& point, const ReportRow& row, double x, double y, double radius,
                 const Span& psnrs) {
  const std::string title = "<title>" + escaped(titleOf(point, row)) + "</title>";
  if (point.kind == PlotKind::none) {
    const std::string r = coordinate(radius);
    const std::string r2 = coordinate(2 * radius);
    return "<path class=\"none\" d=\"M" + coordinate(x) + " " + coordinate(y) + "m-" + r + " -" +
           r + "l" + r2 + " " + r2 + "m-" + r2 + " 0l" + r2 + " -" + r2 + "\">" + title +
           "</path>\n";
  }
  const std::string fill =
      point.kind == PlotKind::identical
          ? std::string("class=\"hollow\"")
          : "fill=\"" + colourOf((point.psnr - psnrs.low) / psnrs.width()) + "\"";
  return "<circle cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" r=\"" +
         coordinate(radius) + "\" " + fill + ">" + title + "</circle>\n";
}

/// A kind of map: the coordinate of an eye on the vertical axis, and the panel's outline.
struct MapKind {
  std::string name;
  double Vec3::*up;
  bool isDown;  ///< the values grow downwards
  double panelHalf;
  std::string title;
};

/// Returns axes of equal scale that contain the panel and all eyes, with an aspect ratio between
/// 1:1 and about 2:1.
std::array<Axis, 2> axesOf(const MapKind& kind, const std::vector<ViewPoint>& points,
                           double halfWidth) {
  Span x{-halfWidth, halfWidth};
  Span y{-kind.panelHalf, kind.panelHalf};
  for (const ViewPoint& point : points) {
    x.add(point.eye.x);
    y.add(point.eye.*kind.up);
  }
  const double margin = 0.14 * std::max(x.width(), y.width());
  x.widen(margin);
  y.widen(margin);
  const double shape = std::clamp(y.width() / x.width(), 0.45, 1.0);
  const double scale = std::max(x.width() / mapWidth, y.width() / (shape * mapWidth));
  x.widen(scale * mapWidth - x.width());
  y.widen(scale * shape * mapWidth - y.width());
  const double bottom = mapTop + shape * mapWidth;
  Axis up{y.low, y.high, bottom, mapTop};
  if (kind.isDown) std::swap(up.from, up.to);
  return {Axis{x.low, x.high, mapLeft, mapLeft + mapWidth}, up};
}

std::string panelMark(const MapKind& kind, const Axis& across, const Axis& up, double halfWidth) {
  const double left = across.at(-halfWidth);
  const double top = std::min(up.at(-kind.panelHalf), up.at(kind.panelHalf));
  const double height = std::abs(up.at(kind.panelHalf) - up.at(-kind.panelHalf));
  const bool isBar = kind.panelHalf == 0;
  return std::string("<rect class=\"") + (isBar ? "bar" : "panel") + "\" x=\"" + coordinate(left) +
         "\" y=\"" + coordinate(isBar ? top - 2 : top) + "\" width=\"" +
         coordinate(across.at(halfWidth) - left) + "\" height=\"" + coordinate(isBar ? 4 : height) +
         "\"><title>the panel</title></rect>\n";
}

std::string map(const MapKind& kind, const std::vector<ReportRow>& rows,
                const std::vector<ViewPoint>& points, double halfWidth, const Span& psnrs) {
  const auto [across, up] = axesOf(kind, points, halfWidth);
  std::string text = "<svg class=\"map\" viewBox=\"0 0 376 " +
                     coordinate(std::max(up.from, up.to) + 46) + "\" role=\"img\" aria-label=\"" +
                     kind.name + "\">" + svgText(mapLeft, 17, "start", kind.name) +
                     svgFrame(across, up, "x in m, to the viewer's right", kind.title) +
                     panelMark(kind, across, up, halfWidth) + "<g class=\"points\">\n";
  for (const ViewPoint& point : points)
    text += mark(point, rows[point.row], across.at(point.eye.x), up.at(point.eye.*kind.up),
                 radiusFor(points.size()), psnrs);
  return text + "</g></svg>\n";
}

}  // namespace

std::string colourBar(double low, double high, const std::string& unit) {
  constexpr int steps = 64;
  const Axis up{low, high, 250, 30};
  std::string text = "<svg class=\"colours\" viewBox=\"0 0 84 266\" role=\"img\" aria-label=\"" +
                     escaped(unit) + "\">" + svgText(4, 17, "start", unit);
  for (int k = 0; k < steps; ++k)
    text += "<rect x=\"4\" y=\"" + coordinate(up.from - 220.0 * (k + 1) / steps) +
            "\" width=\"20\" height=\"4\" fill=\"" + colourOf((k + 0.5) / steps) + "\"/>";
  for (const Tick& tick : linearTicks(up, 6)) {
    const double y = up.at(tick.value);
    text += svgLine(24, y, 29, y, "tick") + svgText(33, y + 4, "start", tick.text);
  }
  return text + "</svg>\n";
}

std::string cameraMaps(const std::vector<ReportRow>& rows, const DisplayParams& display) {
  const Span psnrs = psnrSpan(rows);
  const MapKind above{"From above", &Vec3::z, true, 0, "z in m, toward the viewer"};
  const MapKind front{"From the front", &Vec3::y, false, display.size[1] / 2, "y in m, up"};
  std::string text;
  for (const std::string& test : testsOf(rows)) {
    const std::vector<ViewPoint> points = pointsOf(rows, test, display);
    text += "<figure><figcaption>" + escaped(test) + "</figcaption><div class=\"row\">\n";
    for (const MapKind& kind : {above, front})
      text += map(kind, rows, points, display.size[0] / 2, psnrs);
    if (psnrs.low < psnrs.high) text += colourBar(psnrs.low, psnrs.high, "PSNR in dB");
    text += "</div></figure>\n";
  }
  return text;
}

}  // namespace hogelscope
