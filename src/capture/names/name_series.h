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

/// Returns the name of a file below a folder, such as "03/05.png".
std::string nameBelow(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Returns the series of the files below a folder, sorted by their texts; a single file is a series
/// too. A date with a time is one number, 20240102101530. Where names differ in one letter before a
/// number, as in A1, A2, B1, B2, the letter is a number too: its place in the alphabet.
std::vector<NameSeries> seriesOf(const std::filesystem::path& folder,
                                 const std::vector<std::filesystem::path>& files);

/// The parts of a name that are a view's row and column (R, C), its running number (N) or its
/// coordinates (x, y).
using SeriesReading = std::map<char, std::size_t>;

/// Returns the possible readings of a series by kind, the best kind first: rows and columns, two
/// coordinates, a running number, one coordinate. Within a kind, the reading with the fewest
/// missing views is the right one.
std::vector<std::vector<SeriesReading>> readingsOf(const NameSeries& series);

std::vector<NamedView> viewsOf(const NameSeries& series, const SeriesReading& reading);

/// Returns a pattern with this reading of the names of files below a folder; "" if there is none.
std::string patternOf(const std::filesystem::path& folder, const NameSeries& series,
                      const SeriesReading& reading);

}  // namespace hogelscope
