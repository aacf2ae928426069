// SPDX-License-Identifier: BSD-3-Clause
// Reads views of a light field as grey images, or in colour, in the order of its files.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "capture/order/view_order.h"
#include "core/optics/image.h"
#include "core/panel/display.h"

namespace hogelscope {

/// The views of a light field in the order of its files: `rows`, `columns`, `shear` and `incoming`
/// are not applied.
struct GreyViews {
  GreyGrid grid;
  /// Returns a view of the grid that is not missing in colour; null if the light field does not fit
  /// into memory.
  std::function<FloatImage(int row, int column, const Progress& progress)> colours;
  std::string pattern;  ///< of the file names
  /// The positions of the first and the last column (x) and row (y), from the file names.
  std::optional<std::array<double, 2>> columnsFromTo;
  std::optional<std::array<double, 2>> rowsFromTo;
  /// The tiles of a quilt as they lie in the image; none for other layouts.
  std::optional<GreyGrid> tiles;
  bool isCounted = false;  ///< the views have one running number, whose order `scan` gives
  bool isLoose = false;    ///< ViewFiles::isLoose
  /// For the user: views that are missing or empty, a surplus view.
  std::vector<std::string> warnings;
};

/// Opens the views; none for a live light field, or if it is too large to be read here. Throws
/// InputError as openLightField() does.
std::optional<GreyViews> greyViewsOf(const LightFieldParams& params, const DisplayParams& display,
                                     const Progress& progress);

}  // namespace hogelscope
