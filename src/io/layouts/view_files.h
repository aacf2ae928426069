// SPDX-License-Identifier: BSD-3-Clause
// Finds a folder's views and reads their row and column from the file names.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/light_field/light_field.h"

namespace hogelscope {

/// A complete grid of views, row by row, both numbers ascending as the file names have them.
struct ViewFiles {
  int rows = 0;
  int columns = 0;
  std::vector<std::filesystem::path> files;
};

/// Finds the views. `directions` (columns, rows; 0 = not known) is needed if one running number
/// names the views and their count is not a square. Throws InputError: no folder, no match, missing
/// view.
ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions);

}  // namespace hogelscope
