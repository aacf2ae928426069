// SPDX-License-Identifier: BSD-3-Clause
// Plots of series of points over two axes, laid out once for pages (SVG) and windows
// (chart/plot_painting). Lengths are SVG units, which are points on the screen.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/axis.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

struct Plot {
  struct Point {
    double across = 0;
    double up = 0;  ///< infinite: identical, in a separate strip above the others
    std::string title;
    std::size_t row = 0;  ///< the point's row in the table
    Interval interval{};  ///< drawn in plots with curves only
    std::string name{};   ///< drawn in the window beside the chosen point
    double shade = 0;     ///< drawn in the window as a colour of `shades`
  };
  struct Series {
    std::string name;
    std::vector<Point> points;
    double radius = 4;  ///< of the marks
  };

  std::string titleAcross;
  std::string titleUp;
  std::array<double, 2> leastRange{};  ///< of the values across and up
  bool hasCurves = false;              ///< whether the points of a series are connected
  bool isLogarithmic = false;          ///< `across` is log10 of the ticks' values
  std::vector<Series> series;

  // For the window only.
  double panel = 0;  ///< width of a bar at 0; above 0 in maps, whose axes have one scale
  std::optional<Axis> shades{};   ///< low and high of the colour bar
  std::optional<double> limit{};  ///< a line across at this height
  std::optional<double> mark{};   ///< an upright line at this place, if it is on the axis
  std::string markName{};
};

/// The area of a plot: `width` × `height`, with margins for its titles.
struct PlotBox {
  double width = 0;
  double height = 0;
  double below = 44;
  double right = 16;
  double left = 62;
  double top = 14;
};

/// The axes of a plot in a box.
struct PlotArea {
  Axis across;
  Axis up;
  std::size_t count = 0;  ///< the number of series
  bool hasIdentical = false;

  struct Place {
    double x = 0;
    double y = 0;
  };
  /// Returns a point's place. Identical points of different series lie side by side, because they
  /// share their x.
  [[nodiscard]] Place placeOf(const Plot::Point& point, std::size_t series) const;
};
PlotArea areaOf(const Plot& plot, const PlotBox& box);
/// Returns the ticks of the horizontal axis; those without a text are minor.
std::vector<Tick> ticksAcross(const Plot& plot, const Axis& across);
std::vector<Tick> ticksUp(const Axis& up);

/// Returns the corners of a series' marks in radii, x and y in turn; empty for a circle.
std::vector<double> markCorners(std::size_t series);

/// Returns the dashes of a series' curve, so that it is told from others without colours: lengths
/// of lines and gaps in turn; none for a line without gaps.
std::vector<double> dashesOf(std::size_t series);

/// Returns the plot as an element `<svg>` of the class `style`. Below the box are the names of the
/// series with their marks, if there are several.
std::string svgOf(const Plot& plot, const PlotBox& box, std::string_view style,
                  const std::string& label);

// SVG elements for other figures. `more` are attributes.

/// Returns the start of an element `<svg>` of the class `style`; `label` is read to those who do
/// not see it.
std::string svgStart(std::string_view style, double width, const std::string& height,
                     const std::string& label);
/// Returns the start of a series' group: its marks are filled, and its lines of the classes "curve"
/// and "interval" are drawn, in its colour.
std::string svgGroup(std::size_t series);
/// The mean width of a letter of a plot's text, SVG units.
constexpr double letterWidth = 7.2;
/// Returns the characters of a name that fit into a width, without its middle if it has more.
std::string shortName(const std::string& name, double width);
/// Returns the width of a text as it is drawn, about.
double textWidth(const std::string& text);
/// Formats a coordinate with two digits after the point.
std::string coordinate(double value);
/// Returns a text element; `anchor` is start, middle or end.
std::string svgText(double x, double y, std::string_view anchor, const std::string& text);
/// Returns a text over lines, which end around its letters.
std::string svgTextOver(double x, double y, std::string_view anchor, const std::string& text);
std::string svgLine(double x1, double y1, double x2, double y2, const std::string& more);
std::string svgRectangle(double x, double y, double width, double height, const std::string& more);
/// Returns the mark of a series with an element `<title>`, or "".
std::string svgMark(std::size_t series, double x, double y, double radius, const std::string& more,
                    const std::string& title);
/// Returns the attribute of a false colour, 0 … 1.
std::string svgFill(double share);
/// Returns an upright scale of the false colours, with `unit` above; 64 units wide with its text.
std::string svgScale(double left, const Axis& up, const std::string& unit);
/// Returns grid, ticks, frame and titles around the area of the two axes; linear ticks by default.
std::string svgFrame(const Axis& across, const Axis& up, const std::string& titleAcross,
                     const std::string& titleUp, std::vector<Tick> ticks = {});

}  // namespace hogelscope
