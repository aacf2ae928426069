// SPDX-License-Identifier: BSD-3-Clause
#include "page/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "core/base/colour_map.h"
#include "core/base/text.h"
#include "page/html.h"

namespace hogelscope {

namespace {

constexpr double strip = 28;  ///< for the identical points

std::vector<Tick> linearTicksAcross(const Axis& across) {
  return linearTicks(across, std::max(2, int(std::abs(across.to - across.from) / 50)));
}

/// Extends the axis beyond the points by 5 %, and to a range of at least twice `least`; an axis
/// without a range gets one.
void pad(Axis& axis, double least) {
  if (!(axis.low <= axis.high)) axis.low = axis.high = 0;
  if (axis.low == axis.high && least == 0) least = 0.5;
  const double by = std::max(0.05 * (axis.high - axis.low), least - (axis.high - axis.low) / 2);
  axis.low -= by;
  axis.high += by;
}

/// Extends the axis with the larger scale, so that a unit is as long on both.
void shareScale(Axis& across, Axis& up) {
  const auto unit = [](const Axis& axis) {
    return std::abs(axis.to - axis.from) / (axis.high - axis.low);
  };
  Axis& wide = unit(across) > unit(up) ? across : up;
  const double factor = unit(wide) / std::min(unit(across), unit(up));
  const double middle = (wide.low + wide.high) / 2;
  wide.low = middle + factor * (wide.low - middle);
  wide.high = middle + factor * (wide.high - middle);
}

std::string dashAttribute(std::size_t series) {
  std::string dashes;
  for (const double length : dashesOf(series))
    dashes += (dashes.empty() ? "" : " ") + numberText(length);
  return dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"";
}

/// Returns the line through the points of a series, and their intervals.
std::string svgCurve(const Plot::Series& series, std::size_t number, const PlotArea& area) {
  std::string line, bars;
  for (const Plot::Point& point : series.points) {
    const auto [x, y] = area.placeOf(point, 0);
    line += (line.empty() ? "" : " ") + coordinate(x) + "," + coordinate(y);
    bars += svgLine(x, area.up.at(point.interval.low), x, area.up.at(point.interval.high),
                    "class=\"interval\"");
  }
  return "<polyline class=\"curve\" points=\"" + line + "\"" + dashAttribute(number) + "/>" + bars +
         "\n";
}

constexpr double legendLine = 19;

/// The names of the series, side by side as far as there is room.
struct Legend {
  std::string svg;
  double height = 0;
};

Legend legendOf(const Plot& plot, const PlotBox& box) {
  constexpr double mark = 30;
  Legend legend;
  if (plot.series.size() < 2) return legend;
  double x = box.left;
  double y = box.height + 12;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const std::string name = shortName(plot.series[k].name, box.width - box.left - mark);
    const double width = mark + textWidth(name) + 14;
    if (x > box.left && x + width > box.width) {
      x = box.left;
      y += legendLine;
    }
    legend.svg += svgGroup(k);
    if (plot.hasCurves)
      legend.svg += "<polyline class=\"curve\" points=\"" + coordinate(x) + "," + coordinate(y) +
                    " " + coordinate(x + mark - 6) + "," + coordinate(y) + "\"" + dashAttribute(k) +
                    "/>";
    legend.svg += svgMark(k, x + (mark - 6) / 2, y, 4.5, "", "") + "</g>" +
                  svgText(x + mark, y + 4, "start", name) + "\n";
    x += width;
  }
  legend.height = y + 10 - box.height;
  return legend;
}

}  // namespace

std::string svgStart(std::string_view style, double width, const std::string& height,
                     const std::string& label) {
  return "<svg class=\"" + std::string(style) + "\" viewBox=\"0 0 " + numberText(width) + " " +
         height + "\" role=\"img\" aria-label=\"" + escaped(label) + "\">";
}

std::string svgGroup(std::size_t series) {
  const std::string colour = seriesColour(series);
  return "<g class=\"points\" fill=\"" + colour + "\" color=\"" + colour + "\">";
}

double textWidth(const std::string& text) {
  return letterWidth * double(charactersOf(text).size());
}

std::string shortName(const std::string& name, double width) {
  constexpr double least = 8;  // letters
  std::vector<std::string> letters = charactersOf(name);
  const auto most = std::size_t(std::max(least, width / letterWidth));
  if (letters.size() <= most) return name;
  const auto half = std::ptrdiff_t((most - 1) / 2);
  letters.erase(letters.begin() + half, letters.end() - half);
  letters.insert(letters.begin() + half, "…");
  return std::accumulate(letters.begin(), letters.end(), std::string());
}

std::string coordinate(double value) {
  return rounded(value, 2);
}

std::string svgText(double x, double y, std::string_view anchor, const std::string& text) {
  return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" +
         std::string(anchor) + "\">" + escaped(text) + "</text>";
}

std::string svgTextOver(double x, double y, std::string_view anchor, const std::string& text) {
  return "<g paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3\">" +
         svgText(x, y, anchor, text) + "</g>";
}

std::string svgLine(double x1, double y1, double x2, double y2, const std::string& more) {
  return "<line x1=\"" + coordinate(x1) + "\" y1=\"" + coordinate(y1) + "\" x2=\"" +
         coordinate(x2) + "\" y2=\"" + coordinate(y2) + "\" " + more + "/>";
}

std::string svgRectangle(double x, double y, double width, double height, const std::string& more) {
  return "<rect x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" width=\"" +
         coordinate(width) + "\" height=\"" + coordinate(height) + "\" " + more + "/>";
}

std::string svgMark(std::size_t series, double x, double y, double radius, const std::string& more,
                    const std::string& title) {
  const std::string rest = (more.empty() ? "" : " " + more) + ">" + title;
  const std::vector<double> corners = markCorners(series);
  if (corners.empty())
    return "<circle cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" r=\"" +
           coordinate(radius) + "\"" + rest + "</circle>";
  std::string points;
  for (std::size_t k = 0; k < corners.size(); k += 2)
    points += (k == 0 ? "" : " ") + coordinate(x + radius * corners[k]) + "," +
              coordinate(y + radius * corners[k + 1]);
  return "<polygon points=\"" + points + "\"" + rest + "</polygon>";
}

std::string svgFill(double share) {
  const auto [r, g, b] = falseColour(share);
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "fill=\"#%02x%02x%02x\"", unsigned{r}, unsigned{g},
                unsigned{b});
  return text.data();
}

std::string svgScale(double left, const Axis& up, const std::string& unit) {
  constexpr int steps = 64;
  constexpr double width = 12;
  const double height = (up.from - up.to) / steps;
  std::string text;
  for (int k = 0; k < steps; ++k)
    text += svgRectangle(left, up.from - (k + 1) * height, width, height + 0.5,
                         svgFill((k + 0.5) / steps));
  for (const Tick& tick : linearTicks(up, 5))
    text += svgText(left + width + 4, up.at(tick.value) + 4, "start", tick.text);
  return text + svgText(left, up.to - 11, "start", unit) + "\n";
}

std::vector<double> markCorners(std::size_t series) {
  static const std::array<std::vector<double>, 5> corners{{{},
                                                           {-1, -1, 1, -1, 1, 1, -1, 1},
                                                           {0, -1.2, 1.2, 1, 0, 1, -1.2, 1},
                                                           {0, -1.4, 1.4, 0, 0, 1.4, -1.4, 0},
                                                           {0, 1.2, 1.2, -1, 0, -1, -1.2, -1}}};
  return corners[series % corners.size()];
}

std::vector<double> dashesOf(std::size_t series) {
  static const std::array<std::vector<double>, 4> dashes{{{}, {7, 3}, {2, 2}, {8, 3, 2, 3}}};
  return dashes[series % dashes.size()];
}

PlotArea::Place PlotArea::placeOf(const Plot::Point& point, std::size_t series) const {
  const double share = (double(series) + 0.5) / double(std::max<std::size_t>(count, 1));
  return {across.at(point.across),
          std::isinf(point.up) ? up.to - strip - 2 + 24 * share : up.at(point.up)};
}

PlotArea areaOf(const Plot& plot, const PlotBox& box) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  PlotArea area{{infinite, -infinite, box.left, std::max(box.left + 20, box.width - box.right)},
                {infinite, -infinite, std::max(box.top + 20, box.height - box.below), box.top},
                plot.series.size(),
                false};
  const auto include = [](Axis& axis, double value) {
    axis.low = std::min(axis.low, value);
    axis.high = std::max(axis.high, value);
  };
  for (const Plot::Series& series : plot.series)
    for (const Plot::Point& point : series.points) {
      include(area.across, point.across);
      if (std::isinf(point.up)) {
        area.hasIdentical = true;
        continue;
      }
      include(area.up, plot.hasCurves ? point.interval.low : point.up);
      include(area.up, plot.hasCurves ? point.interval.high : point.up);
    }
  if (plot.limit) include(area.up, *plot.limit);
  if (plot.panel > 0) {
    for (const double edge : {-plot.panel / 2, plot.panel / 2}) include(area.across, edge);
    include(area.up, 0);
  }
  pad(area.across, plot.leastRange[0]);
  pad(area.up, plot.leastRange[1]);
  if (plot.panel > 0) shareScale(area.across, area.up);
  if (area.hasIdentical) area.up.to += strip;
  return area;
}

/// Returns round ticks, also for an axis of logarithms.
std::vector<Tick> ticksAcross(const Plot& plot, const Axis& across) {
  if (!plot.isLogarithmic) return linearTicksAcross(across);
  // Decades have texts such as 0.01 and 100; between them 2 and 5 have one where there is room.
  const double decimals = std::max(0.0, -std::floor(across.low));
  const double letters = std::max(decimals > 0 ? 2 + decimals : 1, 1 + std::floor(across.high));
  std::vector<Tick> ticks = logarithmicTicks(across, 6 + 7 * letters);
  if (std::ranges::count_if(ticks, [](const Tick& tick) { return !tick.text.empty(); }) < 2)
    ticks = linearTicks({std::pow(10, across.low), std::pow(10, across.high)}, 5);
  for (Tick& tick : ticks) tick.value = std::log10(tick.value);
  return ticks;
}

std::vector<Tick> ticksUp(const Axis& up) {
  return linearTicks(up, std::max(2, int(std::abs(up.to - up.from) / 30)));
}

std::string svgFrame(const Axis& across, const Axis& up, const std::string& titleAcross,
                     const std::string& titleUp, std::vector<Tick> ticks) {
  const double left = std::min(across.from, across.to);
  const double right = std::max(across.from, across.to);
  const double top = std::min(up.from, up.to);
  const double bottom = std::max(up.from, up.to);
  constexpr const char* grid = "class=\"grid\"";
  std::string text;
  if (ticks.empty()) ticks = linearTicksAcross(across);
  for (const Tick& tick : ticks) {
    const double x = across.at(tick.value);
    text += svgLine(x, top, x, bottom, grid);
    if (!tick.text.empty()) text += svgText(x, bottom + 17, "middle", tick.text);
  }
  for (const Tick& tick : ticksUp(up)) {
    const double y = up.at(tick.value);
    text += svgLine(left, y, right, y, grid) + svgText(left - 6, y + 4, "end", tick.text);
  }
  text += svgRectangle(left, top, right - left, bottom - top, "class=\"frame\"") +
          svgText((left + right) / 2, bottom + 36, "middle", titleAcross);
  return text + "<g transform=\"translate(13 " + coordinate((top + bottom) / 2) +
         ") rotate(-90)\">" + svgText(0, 0, "middle", titleUp) + "</g>\n";
}

std::string svgOf(const Plot& plot, const PlotBox& box, std::string_view style,
                  const std::string& label) {
  const PlotArea area = areaOf(plot, box);
  const Legend legend = legendOf(plot, box);
  std::string text = svgStart(style, box.width, numberText(box.height + legend.height), label) +
                     svgFrame(area.across, area.up, plot.titleAcross, plot.titleUp,
                              ticksAcross(plot, area.across));
  if (area.hasIdentical) text += svgText(box.left - 6, 28, "end", "identical");
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    text += svgGroup(k) + "\n";
    if (plot.hasCurves) text += svgCurve(plot.series[k], k, area);
    for (const Plot::Point& point : plot.series[k].points) {
      const auto [x, y] = area.placeOf(point, k);
      text +=
          svgMark(k, x, y, plot.series[k].radius, std::isinf(point.up) ? "class=\"hollow\"" : "",
                  "<title>" + escaped(point.title) + "</title>") +
          "\n";
    }
    text += "</g>\n";
  }
  return text + legend.svg + "</svg>\n";
}

}  // namespace hogelscope
