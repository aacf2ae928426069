// SPDX-License-Identifier: BSD-3-Clause
// PSNR over camera position, from above and from the front; and over the horizontal viewing angle
// or the states, one series for each test. Quality over bits per directional pixel, a curve for
// each group of tests.
#include "report/page/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "core/base/colour_map.h"
#include "core/base/text.h"
#include "page/html.h"

namespace hogelscope {

namespace {

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
                                const DisplayParams& display) {
  const RigidTransform displayFromWorld =
      transformFromPose(display.position, display.orientation).inverse();
  std::vector<ViewPoint> points;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ReportRow& row = rows[k];
    if (row.test != test) continue;
    ViewPoint point{k, displayFromWorld.point(row.eye),
                    row.problem.empty() ? row.values[psnrSeenColumn] : NAN};
    if (std::isnan(point.psnr))
      point.kind = PlotKind::none;
    else if (std::isinf(point.psnr))
      point.kind = PlotKind::identical;
    points.push_back(point);
  }
  std::stable_sort(points.begin(), points.end(), [](const ViewPoint& a, const ViewPoint& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.kind == PlotKind::compared && a.psnr > b.psnr;
  });
  return points;
}

/// Returns the tooltip of a point.
std::string titleOf(const ViewPoint& point, const ReportRow& row) {
  std::string text = row.state + ": ";
  if (point.kind == PlotKind::none) {
    text += row.problem.empty() ? "nothing to compare" : row.problem;
  } else {
    text += point.kind == PlotKind::identical ? "identical" : rounded(point.psnr, 2) + " dB";
    const double ssim = row.values[ssimSeenColumn];
    if (!std::isnan(ssim)) text += ", SSIM " + rounded(ssim, 4);
  }
  return text + "; eye " + rounded(point.eye.x, 3) + ", " + rounded(point.eye.y, 3) + ", " +
         rounded(point.eye.z, 3) + " m";
}

/// Returns the radius of points, smaller for many points.
double radiusFor(std::size_t points) {
  if (points <= 40) return 6;
  return points <= 300 ? 4 : 2.5;
}

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

double angleOf(const Vec3& eye) {
  return std::atan2(eye.x, eye.z) * 180 / std::numbers::pi;
}

/// Returns a text such as "a.jpg: 0.25 bits, 31.20 (30.95 … 31.44)".
std::string titleOf(const TestSummary& test, double rate, std::size_t mean, int decimals) {
  const auto number = [&](double value) { return rounded(value, decimals); };
  const Interval& interval = test.intervals[mean];
  return test.test + ": " + numberText(rate) + " bits, " + number(test.summary.means[mean]) + " (" +
         number(interval.low) + " … " + number(interval.high) + ")";
}

/// Returns the finite points of a group, in ascending order of rate.
Plot::Series curveOf(const RateGroup& group, const std::vector<TestSummary>& summaries,
                     std::size_t mean, int decimals) {
  Plot::Series curve{group.name, {}, 4.5};
  for (const TestRate& rate : group.tests)
    for (const TestSummary& test : summaries)
      if (test.test == rate.test && std::isfinite(test.summary.means[mean]))
        curve.points.push_back({std::log10(rate.rate), test.summary.means[mean],
                                titleOf(test, rate.rate, mean, decimals), 0, test.intervals[mean]});
  std::ranges::sort(curve.points, {}, &Plot::Point::across);
  return curve;
}

Plot ratePlot(const std::vector<TestSummary>& summaries, const std::vector<RateGroup>& groups,
              std::size_t index, const MetricMean& mean) {
  Plot plot{"bits per directional pixel",
            mean.title + (mean.unit.empty() ? "" : " in " + mean.unit),
            {1e-3, 1e-3},
            true,
            true,
            {}};
  for (const RateGroup& group : groups)
    plot.series.push_back(curveOf(group, summaries, index, mean.decimals));
  return plot;
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
      series.points.back().name = rows[point.row].state + "  " + rounded(point.psnr, 1) + " dB";
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

std::string ratePlots(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                      const std::vector<RateGroup>& groups) {
  if (groups.empty()) return {};
  std::string plots, legend;
  for (std::size_t k = 0; k < metrics.means().size(); ++k) {
    const MetricMean& mean = metrics.means()[k];
    const bool isOfPlugin = k > meanPsnrYuvSeen;
    if (!mean.isQuality || !(mean.isSeen || isOfPlugin)) continue;
    const Plot plot = ratePlot(summaries, groups, k, mean);
    legend = legendOf(plot);
    if (std::ranges::any_of(plot.series, [](const auto& curve) { return !curve.points.empty(); }))
      plots += svgOf(plot, {376, 296, 46, 12}, "map", plot.titleUp + " over rate");
  }
  return "<figure><div class=\"plots\">\n" + plots + "</div>" + legend + "</figure>\n";
}

}  // namespace hogelscope
