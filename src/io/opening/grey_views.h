// SPDX-License-Identifier: BSD-3-Clause
// Reads views of a light field as grey pictures, in the order of its files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "capture/order/view_order.h"
#include "core/panel/display.h"

namespace hogelscope {

/// The views of a light field's files as they lie there: `rows`, `columns`, `shear` and `incoming`
/// are not applied.
struct GreyViews {
  GreyGrid grid;
  std::string pattern;  ///< of the names of its files
  /// Where the first and the last column (x) and row (y) were taken from, as the file names have
  /// it.
  std::optional<std::array<double, 2>> columnsFromTo;
  std::optional<std::array<double, 2>> rowsFromTo;
  /// Of a quilt: its tiles as they lie in the picture.
  std::optional<GreyGrid> tiles;
  std::vector<std::string> warnings;  ///< for the user: missing views, and one too many
};

/// None for a light field without files, or of more pixels than are looked at on the way. Throws
/// InputError as openLightField() does.
std::optional<GreyViews> greyViewsOf(const LightFieldParams& params, const DisplayParams& display,
                                     const Progress& progress);

}  // namespace hogelscope
