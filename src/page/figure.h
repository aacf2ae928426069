// SPDX-License-Identifier: BSD-3-Clause
// Figures of a page that are files too: for a paper, as SVG, with their points as CSV.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "page/plot.h"

namespace hogelscope {

/// The widths of a column and of a page of a paper in two columns, in mm and in SVG units. Text has
/// 8 points in both.
inline constexpr double columnWidth = 86;
inline constexpr double pageWidth = 178;
inline constexpr double columnUnits = 376;
inline constexpr double pageUnits = 778;

struct Figure {
  std::string name;  ///< of its files, without an ending
  std::string title;
  std::string caption;
  /// Draws an element `<svg>` for a column or for a page: columnUnits or pageUnits wide.
  std::function<std::string(double width)> draw;
  std::string csv;      ///< its points, with a line of names
  bool isWide = false;  ///< whether HTML shows it as it is drawn for a page

  /// Returns it as HTML shows it.
  [[nodiscard]] std::string svg() const { return draw(isWide ? pageUnits : columnUnits); }
};

/// Returns the class of an `<svg>` so wide: "map" for a column, "wide" for a page.
std::string_view styleFor(double width);

/// Returns the figure of a plot.
Figure figureOf(const Plot& plot, const std::string& name, const std::string& title,
                const std::string& csv);

/// Returns the figure as an element of a page; its caption may be empty.
std::string figureTag(const Figure& figure);

/// The endings of a figure's files: drawn for a column, drawn for a page, its points.
inline constexpr std::array figureEndings{".svg", "_page.svg", ".csv"};

/// Writes FOLDER/plots/NAME and the endings of each figure. Throws InputError.
void writeFigures(const std::filesystem::path& folder, const std::vector<Figure>& figures);

}  // namespace hogelscope
