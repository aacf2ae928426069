// SPDX-License-Identifier: BSD-3-Clause
// Series of file names that agree in all but their numbers, and the possible meanings of the
// numbers.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "capture/names/view_grid.h"

namespace hogelscope {

/// The texts and numbers of a name in turn; the first and the last part are texts, which may be
/// empty: {"out_", "00", "_", "-1.5", ".png"}.
using NameParts = std::vector<std::string>;

struct NameSeries {
  std::vector<std::filesystem::path> files;
  std::vector<NameParts> parts;  ///< for each file; their texts are equal
};

/// Returns the series, sorted by their texts; a single file is a series too.
std::vector<NameSeries> seriesOf(const std::vector<std::filesystem::path>& files);

/// The parts of a name that are a view's row and column (R, C), its running number (N) or its
/// coordinates (x, y).
using SeriesReading = std::map<char, std::size_t>;

/// Returns the possible readings of a series by kind, the best kind first: rows and columns, two
/// coordinates, a running number, one coordinate. Within a kind, the reading with the fewest
/// missing views is the right one.
std::vector<std::vector<SeriesReading>> readingsOf(const NameSeries& series);

std::vector<NamedView> viewsOf(const NameSeries& series, const SeriesReading& reading);

/// Returns a pattern with this reading of the names; "" if there is none.
std::string patternOf(const NameSeries& series, const SeriesReading& reading);

}  // namespace hogelscope
