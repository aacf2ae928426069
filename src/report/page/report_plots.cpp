// SPDX-License-Identifier: BSD-3-Clause
// PSNR over camera position, from above and from the front, and over the horizontal viewing angle
// or the states. Quality over bits per directional pixel, a curve for each group of tests. The
// error over hogels and directions.
#include "report/page/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "core/base/text.h"
#include "page/html.h"
#include "report/page/test_names.h"

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
  std::string text = viewName(row) + ": ";
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
constexpr double mapTop = 40;
constexpr double scaleGap = 20;  ///< between a map and its scale of colours

/// Returns the width of a map in a figure so wide, which leaves room for titles and colours.
double mapWidthIn(double width) {
  return width - 148;
}

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

std::string mark(const ViewPoint& point, const std::string& name, double x, double y, double radius,
                 const Span& psnrs) {
  const std::string title = "<title>" + escaped(name) + "</title>";
  if (point.kind == PlotKind::none) {
    const std::string r = coordinate(radius);
    const std::string r2 = coordinate(2 * radius);
    return "<path class=\"none\" d=\"M" + coordinate(x) + " " + coordinate(y) + "m-" + r + " -" +
           r + "l" + r2 + " " + r2 + "m-" + r2 + " 0l" + r2 + " -" + r2 + "\">" + title +
           "</path>\n";
  }
  const std::string fill = point.kind == PlotKind::identical
                               ? std::string("class=\"hollow\"")
                               : svgFill((point.psnr - psnrs.low) / psnrs.width());
  return svgMark(0, x, y, radius, fill, title) + "\n";
}

/// A kind of map: the coordinate of an eye on the vertical axis, and the panel's outline.
struct MapKind {
  std::string name;  ///< of its files
  std::string title;
  double Vec3::*up;
  bool isDown;  ///< the values grow downwards
  double panelHalf;
  std::string titleUp;
};

/// Returns axes of equal scale that contain the panel and all eyes, with an aspect ratio between
/// 1:1 and about 2:1; the map of a page is flatter.
std::array<Axis, 2> axesOf(const MapKind& kind, const std::vector<ViewPoint>& points,
                           double halfWidth, double mapWidth) {
  constexpr double highest = 400;
  Span x{-halfWidth, halfWidth};
  Span y{-kind.panelHalf, kind.panelHalf};
  for (const ViewPoint& point : points) {
    x.add(point.eye.x);
    y.add(point.eye.*kind.up);
  }
  const double margin = 0.14 * std::max(x.width(), y.width());
  x.widen(margin);
  y.widen(margin);
  const double shape =
      std::clamp(y.width() / x.width(), 0.45, std::max(0.45, std::min(1.0, highest / mapWidth)));
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

double angleOf(const Vec3& eye) {
  return std::atan2(eye.x, eye.z) * 180 / std::numbers::pi;
}

/// The eyes of a test on a map of this kind.
struct EyeMap {
  MapKind kind;
  std::vector<ViewPoint> points;
  std::vector<std::string> titles;  ///< of the points
  double halfWidth = 0;             ///< of the panel
  Span psnrs;
};

std::string svgOf(const EyeMap& map, double width) {
  const auto& [kind, points, titles, halfWidth, psnrs] = map;
  const auto [across, up] = axesOf(kind, points, halfWidth, mapWidthIn(width));
  const double bottom = std::max(up.from, up.to);
  std::string text = svgStart(styleFor(width), width, coordinate(bottom + 46), kind.title) +
                     svgText(mapLeft, 17, "start", kind.title) +
                     svgFrame(across, up, "x in m, to the viewer's right", kind.titleUp) +
                     panelMark(kind, across, up, halfWidth) + "<g class=\"points\">\n";
  for (std::size_t k = 0; k < points.size(); ++k)
    text += mark(points[k], titles[k], across.at(points[k].eye.x), up.at(points[k].eye.*kind.up),
                 radiusFor(points.size()), psnrs);
  text += "</g>";
  if (psnrs.low < psnrs.high)
    text += svgScale(across.to + scaleGap, {psnrs.low, psnrs.high, bottom, mapTop}, "dB");
  return text + "</svg>\n";
}

/// Whether the eyes of all points lie in one place, by two coordinates.
bool coincide(const std::vector<ViewPoint>& points, double Vec3::*first, double Vec3::*second) {
  return std::ranges::all_of(points, [&](const ViewPoint& point) {
    constexpr double same = 1e-6;  // metres
    const Vec3& eye = points.front().eye;
    return std::abs(point.eye.*first - eye.*first) < same &&
           std::abs(point.eye.*second - eye.*second) < same;
  });
}

/// Returns a line for each eye, in the order of the rows.
std::string csvOf(std::vector<ViewPoint> points, const std::vector<ReportRow>& rows) {
  std::ranges::sort(points, {}, &ViewPoint::row);
  Table table{{"state", "x", "y", "z", "angle", "psnr_seen"}};
  for (const auto& [row, eye, psnr, kind] : points)
    table.push_back({rows[row].state, numberText(eye.x), numberText(eye.y), numberText(eye.z),
                     numberText(angleOf(eye)), numberCell(psnr)});
  return csvText(table);
}

/// Returns a test's figure of a kind of map; none if all eyes are at one place.
std::vector<Figure> mapFigures(const std::vector<ReportRow>& rows, const std::string& test,
                               const std::string& name, const DisplayParams& display) {
  const std::vector<ViewPoint> points = pointsOf(rows, test, display);
  const MapKind above{"above", "Eyes from above", &Vec3::z, true, 0, "z in m, toward the viewer"};
  const MapKind front{"front", "Eyes from the front", &Vec3::y,
                      false,   display.size[1] / 2,   "y in m, up"};
  std::vector<std::string> titles;
  for (const ViewPoint& point : points) titles.push_back(titleOf(point, rows[point.row]));
  std::vector<Figure> figures;
  for (const MapKind& kind : {above, front}) {
    if (coincide(points, &Vec3::x, kind.up)) continue;
    const EyeMap map{kind, points, titles, display.size[0] / 2, psnrSpan(rows)};
    const auto draw = [map](double width) { return svgOf(map, width); };
    figures.push_back({name + "_" + kind.name, kind.title, "", draw, csvOf(points, rows)});
  }
  return figures;
}

Plot psnrPlot(const std::vector<ReportRow>& rows, const std::vector<std::string>& tests,
              const DisplayParams& display, bool isOverAngle) {
  const std::size_t all = testsOf(rows).size();
  Plot plot;
  const bool isInTime = !rows.empty() && rows.front().frame;
  plot.titleAcross = isOverAngle ? "horizontal viewing angle in degrees, to the right"
                     : isInTime  ? "frame"
                                 : "state";
  plot.titleUp = "PSNR in dB";
  plot.leastRange = {2, 1};
  for (const std::string& test : tests) {
    Plot::Series& series = plot.series.emplace_back(Plot::Series{test, {}});
    for (const ViewPoint& point : pointsOf(rows, test, display)) {
      if (point.kind == PlotKind::none) continue;
      const double state =
          isInTime ? rows[point.row].frame.value_or(0) : 1 + double(point.row / all);
      series.points.push_back({isOverAngle ? angleOf(point.eye) : state, point.psnr,
                               titleOf(point, rows[point.row]), point.row});
      series.points.back().name = viewName(rows[point.row]) + "  " + rounded(point.psnr, 1) + " dB";
    }
    series.radius = 0.8 * radiusFor(series.points.size());
  }
  return plot;
}

bool hasNumbers(const Plot& plot) {
  return std::ranges::any_of(plot.series, [](const Plot::Series& series) {
    return std::ranges::any_of(series.points,
                               [](const Plot::Point& point) { return std::isfinite(point.up); });
  });
}

/// A mean of the headlines, plain or weighted by the states' weights.
struct PlottedMean {
  const MetricMean& mean;
  std::size_t index = 0;
  bool isWeighted = false;

  [[nodiscard]] double of(const TestSummary& test) const {
    return test.means(isWeighted).values[index];
  }
  [[nodiscard]] const Interval& intervalOf(const TestSummary& test) const {
    return test.means(isWeighted).intervals[index];
  }
};

/// Returns a text such as "a.jpg: 0.25 bits, 31.20 (30.95 … 31.44)".
std::string titleOf(const TestSummary& test, double rate, const PlottedMean& mean) {
  const auto number = [&](double value) { return rounded(value, mean.mean.decimals); };
  const Interval& interval = mean.intervalOf(test);
  return test.test + ": " + numberText(rate) + " bits, " + number(mean.of(test)) + " (" +
         number(interval.low) + " … " + number(interval.high) + ")";
}

/// Returns the finite points of a group, in ascending order of rate.
Plot::Series curveOf(const RateGroup& group, const std::vector<TestSummary>& summaries,
                     const PlottedMean& mean) {
  Plot::Series curve{group.name, {}, 4.5};
  for (const TestRate& rate : group.tests)
    for (const TestSummary& test : summaries)
      if (test.test == rate.test && std::isfinite(mean.of(test)))
        curve.points.push_back({std::log10(rate.rate), mean.of(test),
                                titleOf(test, rate.rate, mean), 0, mean.intervalOf(test)});
  std::ranges::sort(curve.points, {}, &Plot::Point::across);
  return curve;
}

Plot ratePlot(const std::vector<TestSummary>& summaries, const std::vector<RateGroup>& groups,
              const PlottedMean& mean) {
  Plot plot{"bits per directional pixel",
            mean.mean.title + (mean.mean.unit.empty() ? "" : " in " + mean.mean.unit) +
                (mean.isWeighted ? ", weighted" : ""),
            {1e-3, 1e-3},
            true,
            true,
            {}};
  for (const RateGroup& group : groups) plot.series.push_back(curveOf(group, summaries, mean));
  return plot;
}

std::string csvOf(const std::vector<TestSummary>& summaries, const std::vector<RateGroup>& groups,
                  const PlottedMean& mean) {
  Table table{{"group", "test", "rate_bpp", mean.mean.name, "low", "high", "means"}};
  for (const RateGroup& group : groups)
    for (const TestRate& rate : group.tests) {
      const auto test = std::ranges::find(summaries, rate.test, &TestSummary::test);
      if (test == summaries.end()) continue;
      const Interval& interval = mean.intervalOf(*test);
      table.push_back({group.name, rate.test, numberText(rate.rate), numberCell(mean.of(*test)),
                       numberCell(interval.low), numberCell(interval.high),
                       mean.isWeighted ? "weighted" : "plain"});
    }
  return csvText(table);
}

/// Cells of the panel: their picture, what is along its sides, its scale of colours.
struct CellPlot {
  std::string title;
  std::string titleAcross;
  std::string titleUp;
  std::array<int, 2> cells{};  ///< across, down
  double shape = 1;            ///< height/width
  std::array<double, 2> shades{};
  std::string unit;
};

std::string svgOf(const CellPlot& plot, const std::string& png, double whole) {
  constexpr std::array highest{300.0, 400.0};  // in a column, on a page
  const double shape = std::clamp(plot.shape, 0.2, 5.0);
  const double width = std::min(mapWidthIn(whole), highest[whole > columnUnits ? 1 : 0] / shape);
  const Axis across{0, double(plot.cells[0]), mapLeft, mapLeft + width};
  const Axis down{0, double(plot.cells[1]), mapTop, mapTop + shape * width};
  std::string text = svgStart(styleFor(whole), whole, coordinate(down.to + 46), plot.title) +
                     svgText(mapLeft, 17, "start", plot.title) +
                     svgFrame(across, down, plot.titleAcross, plot.titleUp) + "<image x=\"" +
                     coordinate(across.from) + "\" y=\"" + coordinate(down.from) + "\" width=\"" +
                     coordinate(width) + "\" height=\"" + coordinate(shape * width) +
                     "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," + base64(png) +
                     "\"/>";
  if (plot.shades[0] < plot.shades[1])
    text += svgScale(across.to + scaleGap, {plot.shades[0], plot.shades[1], down.to, down.from},
                     plot.unit);
  return text + "</svg>\n";
}

Figure cellFigure(const std::string& name, const CellPlot& plot, const std::string& png,
                  const std::string& cells) {
  return {name, plot.title, "", [plot, png](double width) { return svgOf(plot, png, width); },
          cells};
}

}  // namespace

Plot psnrPlot(const std::vector<ReportRow>& rows, const DisplayParams& display, bool isOverAngle) {
  return psnrPlot(rows, testsOf(rows), display, isOverAngle);
}

std::vector<Figure> cameraFigures(const std::vector<ReportRow>& rows, std::size_t test,
                                  const DisplayParams& display) {
  const std::string tested = testsOf(rows)[test];
  const std::string name = plotNameOf(tested, test);
  std::vector<Figure> figures = mapFigures(rows, tested, name, display);
  const std::vector<ViewPoint> points = pointsOf(rows, tested, display);
  if (points.size() < 2) return figures;
  const bool isOverAngle = std::ranges::any_of(points, [&](const ViewPoint& point) {
    return std::abs(angleOf(point.eye) - angleOf(points.front().eye)) > 1e-4;
  });
  const Plot plot = psnrPlot(rows, {tested}, display, isOverAngle);
  if (hasNumbers(plot))
    figures.push_back(figureOf(plot, name + (isOverAngle ? "_angle" : "_states"),
                               isOverAngle ? "PSNR over viewing angle" : "PSNR of the states",
                               csvOf(points, rows)));
  return figures;
}

/// Returns the mean of a test's views at each frame: the frame, the mean, and its least view.
struct FrameMean {
  int frame = 0;
  double mean = 0;
  std::string worst;  ///< its state
};
std::vector<FrameMean> frameMeans(const std::vector<ReportRow>& rows, const std::string& test,
                                  const MetricSet& metrics, std::size_t index) {
  std::map<int, std::vector<ReportRow>> ofFrames;
  for (const ReportRow& row : rows)
    if (row.test == test && row.frame) ofFrames[*row.frame].push_back(row);
  std::vector<FrameMean> means;
  for (const auto& [frame, own] : ofFrames) {
    const ReportSummary summary = summariseRows(own, metrics);
    means.push_back({frame, summary.means[index], summary.worst ? own[*summary.worst].state : ""});
  }
  return means;
}

std::vector<Figure> frameFigures(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  std::vector<Figure> figures;
  if (rows.empty() || !rows.front().frame) return figures;
  for (std::size_t k = 0; k < metrics.means().size(); ++k) {
    if (!metrics.isHeadline(k)) continue;
    const MetricMean& mean = metrics.means()[k];
    Plot plot;
    plot.titleAcross = "frame";
    plot.titleUp = mean.title + (mean.unit.empty() ? "" : " in " + mean.unit);
    plot.leastRange = {1, mean.unit == "dB" ? 1 : 1e-3};
    plot.hasCurves = true;
    Table table{{"test", "frame", mean.name}};
    for (const std::string& test : testsOf(rows)) {
      Plot::Series& series = plot.series.emplace_back(Plot::Series{test, {}, 2.5});
      for (const auto& [frame, value, worst] : frameMeans(rows, test, metrics, k)) {
        table.push_back({test, std::to_string(frame), numberCell(value)});
        if (std::isnan(value)) continue;
        series.points.push_back({double(frame),
                                 value,
                                 test + ", frame " + std::to_string(frame) + ": " +
                                     rounded(value, mean.decimals) +
                                     (worst.empty() ? "" : "; worst view " + worst),
                                 0,
                                 {value, value}});
      }
    }
    if (hasNumbers(plot))
      figures.push_back(
          figureOf(plot, "frames_" + mean.name, mean.title + " over time", csvText(table)));
  }
  return figures;
}

std::vector<Figure> rateFigures(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                                const std::vector<RateGroup>& groups) {
  if (groups.empty()) return {};
  const bool isWeighted = std::ranges::any_of(summaries, &TestSummary::hasWeights);
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < metrics.means().size(); ++k) {
    if (!metrics.means()[k].isQuality || !metrics.isHeadline(k)) continue;
    const PlottedMean mean{metrics.means()[k], k, isWeighted};
    const Plot plot = ratePlot(summaries, groups, mean);
    if (hasNumbers(plot))
      figures.push_back(figureOf(plot, "rate_" + mean.mean.name, plot.titleUp + " over rate",
                                 csvOf(summaries, groups, mean)));
  }
  return figures;
}

std::vector<Figure> panelFigures(const ReportPanel& panel, std::size_t test,
                                 const PanelParams& display) {
  const std::string name = plotNameOf(panel.test, test) + "_";
  const auto ofDirections = [&](const char* title, const std::array<double, 2>& shades,
                                const char* unit) {
    const auto half = [](double whole) { return numberText(std::round(50 * whole) / 100); };
    return CellPlot{title,
                    "direction, " + half(display.fov[0]) + "° left to right",
                    "direction, " + half(display.fov[1]) + "° up to down",
                    display.directions,
                    display.fov[1] / display.fov[0],
                    shades,
                    unit};
  };
  const PanelErrorFigures& of = panel.figures;
  const CellPlot hogels{"Error over the hogels",
                        "hogel, from the left",
                        "hogel, from the top",
                        display.hogels,
                        display.size[1] / display.size[0],
                        {0, of.hogelScale},
                        "MSE"};
  const CellPlot directions =
      ofDirections("Error over the directions", {0, of.directionScale}, "MSE");
  std::vector<Figure> figures{
      cellFigure(name + "hogels", hogels, panel.hogels, panel.hogelCells),
      cellFigure(name + "directions", directions, panel.directions, panel.directionCells)};
  if (panel.views.empty()) return figures;
  const CellPlot views =
      ofDirections("Error of the light field's views", {0, panel.viewScale}, "MSE");
  const CellPlot ranks =
      ofDirections("Rank by perceived error − rank by view error", {-1, 1}, "share");
  figures.push_back(cellFigure(name + "views", views, panel.views, panel.viewCells));
  figures.push_back(cellFigure(name + "ranks", ranks, panel.ranks, panel.viewCells));
  return figures;
}

}  // namespace hogelscope
