// SPDX-License-Identifier: BSD-3-Clause
#include "page/map_plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/text.h"

namespace hogelscope {

namespace {

constexpr double scaleRoom = 64;  ///< right of the map, for the scale of colours

/// Returns a stroke that is seen on every colour: white over black.
std::string stroke(double x1, double y1, double x2, double y2, const std::string& more) {
  return svgLine(x1, y1, x2, y2,
                 "stroke=\"#000\" stroke-opacity=\".5\" stroke-width=\"2.6\"" + more) +
         svgLine(x1, y1, x2, y2, "stroke=\"#fff\" stroke-width=\"1.2\"" + more);
}

/// Places names in a map such that none lies on another one or leaves the map on the right.
class Names {
 public:
  explicit Names(double right) : m_right(right) {}

  /// Returns a name beside a point; further ones of about the same place go down, or up.
  std::string at(double x, double y, bool goesDown, const std::string& name) {
    constexpr double gap = 4, line = 14;
    const double width = textWidth(name);
    const bool isLeft = x + gap + width > m_right;
    Place place{isLeft ? x - gap - width : x + gap, y, width};
    while (std::ranges::any_of(m_taken, [&](const Place& other) {
      return std::abs(other.y - place.y) < line && place.x < other.x + other.width + gap &&
             other.x < place.x + place.width + gap;
    }))
      place.y += goesDown ? line : -line;
    m_taken.push_back(place);
    return svgTextOver(isLeft ? x - gap : x + gap, place.y, isLeft ? "end" : "start", name);
  }

 private:
  struct Place {
    double x;
    double y;
    double width;
  };
  double m_right;
  std::vector<Place> m_taken;
};

/// Returns the ticks whose texts have room beside those of the ticks before them in the list.
std::vector<Tick> withRoom(const std::vector<Tick>& ticks, const Axis& across) {
  std::vector<Tick> placed;
  std::ranges::copy_if(ticks, std::back_inserter(placed), [&](const Tick& tick) {
    return std::ranges::none_of(placed, [&](const Tick& other) {
      constexpr double space = 8;
      return std::abs(across.at(tick.value) - across.at(other.value)) <
             (textWidth(tick.text) + textWidth(other.text)) / 2 + space;
    });
  });
  return placed;
}

}  // namespace

std::vector<ContourPiece> contourOf(const MapPlot& plot, double level) {
  std::vector<ContourPiece> pieces;
  const int rows = plot.rows();
  const auto value = [&](int column, int row) {
    return plot.values[std::size_t(row) * std::size_t(plot.columns) + std::size_t(column)];
  };
  const auto place = [&](double column, double row) {
    return std::array{
        plot.across[0] + (column + 0.5) / plot.columns * (plot.across[1] - plot.across[0]),
        plot.up[0] + (row + 0.5) / rows * (plot.up[1] - plot.up[0])};
  };
  constexpr std::array<std::array<int, 2>, 5> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < plot.columns; ++column) {
      std::vector<std::array<double, 2>> crossings;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto [x1, y1] = corners[k];
        const auto [x2, y2] = corners[k + 1];
        const double from = value(column + x1, row + y1);
        const double to = value(column + x2, row + y2);
        if ((from < level) == (to < level) || std::isnan(from) || std::isnan(to)) continue;
        const double share = (level - from) / (to - from);
        crossings.push_back(place(column + x1 + share * (x2 - x1), row + y1 + share * (y2 - y1)));
      }
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        pieces.push_back({crossings[k], crossings[k + 1]});
    }
  return pieces;
}

std::string svgOf(const MapPlot& plot, const PlotBox& box, std::string_view style,
                  const std::string& label) {
  const Axis across{plot.across[0], plot.across[1], box.left, box.width - box.right - scaleRoom};
  const Axis up{plot.up[0], plot.up[1], box.height - box.below, box.top};
  std::string text =
      svgStart(style, box.width, numberText(box.height), label) +
      svgFrame(across, up, plot.titleAcross, plot.titleUp, withRoom(plot.ticks, across));
  const double width = (across.to - across.from) / plot.columns;
  const double height = (up.from - up.to) / std::max(plot.rows(), 1);
  for (std::size_t k = 0; k < plot.values.size(); ++k) {
    const auto column = double(k % std::size_t(plot.columns));
    const auto row = double(k / std::size_t(plot.columns));
    const double share = (plot.values[k] - plot.shades[0]) / (plot.shades[1] - plot.shades[0]);
    // A little more, since neighbours' edges would let the ground through.
    text += svgRectangle(across.from + column * width, up.from - (row + 1) * height, width + 0.3,
                         height + 0.3, svgFill(share)) +
            "\n";
  }
  for (const double level : plot.contours)
    for (const auto& [from, to] : contourOf(plot, level))
      text += stroke(across.at(from[0]), up.at(from[1]), across.at(to[0]), up.at(to[1]), "");
  for (const auto& [from, to, name] : plot.lines)
    text += from == to ? "<circle cx=\"" + rounded(across.at(to[0]), 1) + "\" cy=\"" +
                             rounded(up.at(to[1]), 1) +
                             "\" r=\"5\" fill=\"#ff9a2e\" stroke=\"#fff\" stroke-width=\"1.5\"/>"
                       : stroke(across.at(from[0]), up.at(from[1]), across.at(to[0]), up.at(to[1]),
                                " stroke-dasharray=\"5 4\"");
  Names names(across.to);
  for (const auto& [from, to, name] : plot.lines) {
    if (name.empty()) continue;
    const bool endsBelow = to[1] < from[1];
    text += names.at(across.at(to[0]), up.at(to[1]) + (endsBelow ? -6 : 15), !endsBelow, name);
  }
  const Axis scale{plot.shades[0], plot.shades[1], up.from, up.to};
  return text + svgScale(across.to + 18, scale, plot.unit) + "</svg>\n";
}

}  // namespace hogelscope
