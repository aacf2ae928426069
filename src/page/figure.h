// SPDX-License-Identifier: BSD-3-Clause
// Figures of a page that are files too: for a paper, as SVG, with their points as CSV.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/plot.h"

namespace hogelscope {

/// The widths of a column and of a page of a paper in two columns, in mm. A figure for a column is
/// 376 SVG units wide, so that its text has 8 points.
constexpr double columnWidth = 86;
constexpr double twoColumns = 178;
constexpr double columnUnits = 376;

struct Figure {
  std::string name;  ///< of its files, without an ending
  std::string title;
  std::string caption;
  std::string svg;             ///< an element `<svg>`
  std::string csv;             ///< its points, with a line of names
  double width = columnWidth;  ///< of the file, mm
};

/// Returns a figure for a column.
Figure figureOf(const Plot& plot, const std::string& name, const std::string& title,
                const std::string& csv);

/// Returns the figure as an element of a page; its caption may be empty.
std::string figureTag(const Figure& figure);

/// Writes FOLDER/plots/NAME.svg and NAME.csv of each figure. Throws InputError.
void writeFigures(const std::filesystem::path& folder, const std::vector<Figure>& figures);

}  // namespace hogelscope
