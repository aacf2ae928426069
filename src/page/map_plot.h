// SPDX-License-Identifier: BSD-3-Clause
// Plots of values over a plane: cells in false colours, lines of equal value, marks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/axis.h"
#include "page/plot.h"

namespace hogelscope {

struct MapPlot {
  /// A line across the map, dashed, with a name at its end `to`; with equal ends a dot.
  struct Line {
    std::array<double, 2> from{};  ///< values across and up
    std::array<double, 2> to{};
    std::string name;
  };

  std::string titleAcross;
  std::string titleUp;
  std::string unit;                ///< above the scale of colours
  std::array<double, 2> across{};  ///< values at the left and right edges
  std::array<double, 2> up{};      ///< at the lower and upper edges
  int columns = 0;
  std::vector<double> values;          ///< row by row, the lowest first; NaN: grey
  std::array<double, 2> shades{0, 1};  ///< the ends of the colours
  std::vector<double> contours;        ///< lines of these values are drawn
  std::vector<Line> lines;
  /// They are those of the horizontal axis, the most important first; linear ones by default.
  std::vector<Tick> ticks;

  [[nodiscard]] int rows() const { return columns > 0 ? int(values.size()) / columns : 0; }
};

/// A piece of a line of equal value, in values across and up.
using ContourPiece = std::array<std::array<double, 2>, 2>;
/// Returns the line of a value, interpolated between the middles of cells (marching squares).
std::vector<ContourPiece> contourOf(const MapPlot& plot, double level);

/// Returns the map as an element `<svg>` of the class `style`; `label` is read to those who do not
/// see it. Names of lines are drawn over all lines, beside each other.
std::string svgOf(const MapPlot& plot, const PlotBox& box, std::string_view style,
                  const std::string& label);

}  // namespace hogelscope
