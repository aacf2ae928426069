// SPDX-License-Identifier: BSD-3-Clause
// Series of file names that agree in all but their numbers, and what the numbers may mean.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "capture/names/view_grid.h"

namespace hogelscope {

/// A name's text and numbers in turn, beginning and ending with text, which may be empty: {"out_",
/// "00", "_", "-1.5", ".png"}.
using NameParts = std::vector<std::string>;

struct NameSeries {
  std::vector<std::filesystem::path> files;
  std::vector<NameParts> parts;  ///< of each file; all texts are equal
};

/// Returns the series in the order of their names; a file alone is one, too.
std::vector<NameSeries> seriesOf(const std::vector<std::filesystem::path>& files);

/// Which parts are a view's row and column (R, C), its running number (N) or its coordinates (x,
/// y).
using SeriesReading = std::map<char, std::size_t>;

/// Returns the ways to read a series, the best kind first: rows and columns before coordinates
/// before a running number. Of a kind the one with the fewest holes is meant.
std::vector<std::vector<SeriesReading>> readingsOf(const NameSeries& series);

std::vector<NamedView> viewsOf(const NameSeries& series, const SeriesReading& reading);

/// Returns a pattern that reads the names so; "" if there is none.
std::string patternOf(const NameSeries& series, const SeriesReading& reading);

}  // namespace hogelscope
