// SPDX-License-Identifier: BSD-3-Clause
// A grid of views made of what the file names say of their places.
// docs/formulas.md, Places of views in names.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hogelscope {

/// A file, and what its name says: row and column, one running number, or coordinates alone.
struct NamedView {
  std::filesystem::path file;
  std::optional<std::int64_t> row;
  std::optional<std::int64_t> column;
  std::optional<std::int64_t> number;
  std::optional<double> x;
  std::optional<double> y;
};

/// Reads the numbers and coordinates of a name by their letters: R row, C column, N running number,
/// x and y. Coordinates that are no finite numbers are left out.
NamedView viewNamed(const std::filesystem::path& file, const std::map<char, std::string>& numbers);

/// A grid of views, row by row, both numbers ascending as the file names have them.
struct ViewFiles {
  int rows = 0;
  int columns = 0;
  std::vector<std::filesystem::path> files;  ///< an empty path for a view that is missing
  std::string pattern;  ///< the one that their names alone fit; "" if none can be told
  /// The coordinate x in the names of the first column and of the last one, on average, and y of
  /// the first and the last row; absent if the pattern has no x or no y.
  std::optional<std::array<double, 2>> columnsFromTo;
  std::optional<std::array<double, 2>> rowsFromTo;
  std::string missing;  ///< a line for the user that names the missing views; "" if all are there
  /// A line for the user where one view fewer would make a square; "" elsewhere.
  std::string surplus;
  std::vector<std::string> others;  ///< names of the folder's files that are no views

  /// Returns the files of the views that are there; one at least.
  [[nodiscard]] std::vector<std::filesystem::path> found() const;
};

/// What messages call the views, and the grid's size if the session gives it (columns, rows; 0: it
/// does not).
struct GridSource {
  std::filesystem::path folder;
  std::string pattern;
  std::array<int, 2> directions{0, 0};
  bool isSerpentine = false;    ///< one running number counts every second row from its end
  bool isPatternGiven = false;  ///< by the session
};

/// The rows and columns of views that count row by row.
struct SequenceGrid {
  std::size_t rows = 1;
  std::size_t columns = 1;
  bool isSerpentine = false;

  /// Returns the cell of view k, row · columns + column; of cell k its view.
  [[nodiscard]] std::size_t cellOf(std::size_t k) const {
    const bool isReversed = isSerpentine && k / columns % 2 == 1;
    return isReversed ? k - k % columns + columns - 1 - k % columns : k;
  }
};

/// Makes the grid of `count` views: a square, or else one row, unless the directions are given.
/// Throws InputError where they do not fit.
SequenceGrid gridOfSequence(std::size_t count, const GridSource& source);

/// Makes the grid; `views` is not empty, and all names say the same things. Numbers in equal steps
/// make rows and columns; so do coordinates that lie near one another. One running number counts
/// row by row: a square, or else one row, unless the directions are given. Throws InputError: two
/// files are one view, half of the views or more are missing and the directions do not say so.
ViewFiles gridOf(const std::vector<NamedView>& views, const GridSource& source);

}  // namespace hogelscope
