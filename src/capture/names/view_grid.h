// SPDX-License-Identifier: BSD-3-Clause
// Arranges views in a grid by the numbers in their file names (docs/formulas.md, Places of views in
// names). The grid has an empty path for a missing view: its texels are black, no optical flow is
// computed from or to it, and one warning reports all of them. If half of the grid is missing, the
// names were probably misread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/light_field/light_field.h"

namespace hogelscope {

/// A file and the numbers in its name: row and column, one running number, or only coordinates.
struct NamedView {
  std::filesystem::path file;
  std::optional<std::int64_t> row;
  std::optional<std::int64_t> column;
  std::optional<std::int64_t> number;
  std::optional<double> x;
  std::optional<double> y;
};

/// Reads the numbers and coordinates of a name by their letters: R row, C column, N running number,
/// x and y. Coordinates that are not finite numbers are left out.
NamedView viewNamed(const std::filesystem::path& file, const std::map<char, std::string>& numbers);

/// A grid of views, row by row; the numbers of rows and columns in the file names ascend.
struct ViewFiles {
  int rows = 0;
  int columns = 0;
  std::vector<std::filesystem::path> files;  ///< an empty path for a missing view
  std::string pattern;                       ///< fits only the names of views; "" if there is none
  /// The mean coordinate x in the names of the first and of the last column, and y of the first and
  /// the last row; absent if the pattern has no x or no y.
  std::optional<std::array<double, 2>> columnsFromTo;
  std::optional<std::array<double, 2>> rowsFromTo;
  std::string missing;  ///< a warning that names the missing views; "" if there are none
  /// A warning if one view fewer would make a square; otherwise "".
  std::string surplus;
  /// A warning if the session gives another grid than the names; otherwise "".
  std::string ignored;
  bool isCounted = false;  ///< one running number, whose order LightFieldParams::scan gives
  /// Whether so many running numbers are missing that their grid is hardly more than a guess.
  bool isLoose = false;
  std::vector<std::string> others;  ///< names of the folder's files that are not views
  /// Those of them whose names are those of views, but not their sizes, such as "208 pictures of
  /// 48×48 px"; "" if there are none.
  std::string otherSizes;

  /// Returns the files of the views that are not missing, at least one.
  [[nodiscard]] std::vector<std::filesystem::path> found() const;
};

/// The names of the views in messages, and the grid's size if the session gives it (columns, rows;
/// otherwise 0).
struct GridSource {
  std::filesystem::path folder;
  std::string pattern;
  std::array<int, 2> directions{0, 0};
  ViewScan scan = ViewScan::raster;  ///< how a running number counts
  bool isPatternGiven = false;       ///< the session gives the pattern
};

/// The rows and columns of a grid whose views are counted line by line: by rows or by columns.
struct SequenceGrid {
  std::size_t rows = 1;
  std::size_t columns = 1;
  ViewScan scan = ViewScan::raster;

  /// Returns the cell of view k, row · columns + column.
  [[nodiscard]] std::size_t cellOf(std::size_t k) const;
  /// Returns the view of a cell.
  [[nodiscard]] std::size_t viewOf(std::size_t cell) const;

 private:
  [[nodiscard]] bool isByColumns() const {
    return scan == ViewScan::columns || scan == ViewScan::columnsSerpentine;
  }
  /// Returns the place `at` in a line, or from its end where lines run to and fro.
  [[nodiscard]] std::size_t placeIn(std::size_t line, std::size_t at) const;
};

/// Returns the grid of `count` views: a square, or else one row, unless the directions are given.
/// Throws InputError if they do not fit.
SequenceGrid gridOfSequence(std::size_t count, const GridSource& source);

/// Returns the grid of views; there is at least one, and all names have the same kinds of numbers.
/// Numbers in equal steps form rows and columns; so do coordinates that lie close together. One
/// running number counts the views of a square, or else of one row, unless the directions are given
/// or its gaps repeat, as in a part of a larger grid (0, 4, 8, 36, 40, 44, …). Dates with times and
/// a camera's counter that has begun again are an order alone, without gaps. Throws InputError if
/// two files are the same view, or if half of the views or more are missing and the given
/// directions do not confirm that.
ViewFiles gridOf(const std::vector<NamedView>& views, const GridSource& source);

}  // namespace hogelscope
