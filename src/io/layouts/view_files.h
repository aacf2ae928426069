// SPDX-License-Identifier: BSD-3-Clause
// Finds a folder's views and reads their row and column from the file names.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/light_field/light_field.h"

namespace hogelscope {

/// A complete grid of views, row by row, both numbers ascending as the file names have them.
struct ViewFiles {
  int rows = 0;
  int columns = 0;
  std::vector<std::filesystem::path> files;
  std::string pattern;  ///< the one that the names fit
  /// The coordinate x in the names of the first column and of the last one, on average, and y of
  /// the first and the last row; absent if the pattern has no x or no y.
  std::optional<std::array<double, 2>> columnsFromTo;
  std::optional<std::array<double, 2>> rowsFromTo;
};

/// Finds the views. `directions` (columns, rows; 0 = not known) is needed if one running number
/// names the views and their count is not a square. Where no name fits but there is a folder 0,
/// that of a JPEG Pleno light field's first components, it is looked at. Throws InputError: no
/// folder, no match, missing view.
ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions);

/// Returns a pattern that takes the numbers of rows for those of columns and the other way round;
/// "" for one running number, and for a file name with %d.
std::string transposedPattern(const std::string& pattern);

}  // namespace hogelscope
