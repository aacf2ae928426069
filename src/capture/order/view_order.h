// SPDX-License-Identifier: BSD-3-Clause
// Finds the order of views in a grid by their content: which end of a row was taken from the left,
// which end of a column from the top, and how far the middle depth moves (docs/formulas.md, Order
// of views). The order is judged by occlusions, the only cue that distinguishes depth from reversed
// depth. findViewOrder() is a pure function of grey images, and returns `sure` only where
// independent places agree.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// An 8-bit grey image, row by row from the top.
struct GreyPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;
};

/// Views in the order of their files. `view` is called for a few of them, some more than once.
struct GreyGrid {
  int rows = 0;
  int columns = 0;
  std::function<GreyPicture(int row, int column)> view;
  std::vector<bool> isMissing{};  ///< row by row; empty if none is missing

  [[nodiscard]] bool has(int row, int column) const {
    return row >= 0 && row < rows && column >= 0 && column < columns &&
           (isMissing.empty() ||
            !isMissing[std::size_t(row) * std::size_t(columns) + std::size_t(column)]);
  }
};

enum class Sureness { unknown, likely, sure };

/// The number of places where one surface hides another. In the right order the hiding surface
/// moves left (along columns) or up (along rows) relative to the hidden one.
struct Occlusions {
  using Areas = std::bitset<64>;  ///< 8×8 parts of the image
  int ordered = 0;                ///< places as in the right order
  int reversed = 0;               ///< places as in the reversed order
  Areas orderedAreas;             ///< with such places: a single object may mislead
  Areas reversedAreas;

  [[nodiscard]] int count() const { return ordered + reversed; }
  /// Whether three quarters of at least six places tell the same.
  [[nodiscard]] bool isLeaning() const;
  [[nodiscard]] Occlusions backwards() const;
  Occlusions& operator+=(const Occlusions& more);
};

/// The motion {x, y} of a place of the image, in pixels from one view to the next, along the files'
/// columns and along their rows.
struct PlaceMotion {
  std::array<double, 2> at{};  ///< pixel
  std::array<double, 2> alongColumns{};
  std::array<double, 2> alongRows{};
};

struct ViewOrder {
  /// The files' rows are columns of cameras. The other members, except `motions` and the middle
  /// view, describe the grid after both are exchanged.
  bool isTransposed = false;
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  Sureness sureness = Sureness::unknown;
  /// The motion of the middle depth from one view to the next, in pixels, x along columns and y
  /// along rows, in the order of the files.
  std::array<double, 2> middleMotion{0, 0};
  /// The correlation of x along columns with y along rows: near +1 if both have the same order,
  /// near -1 if one is reversed, 0 if it was not measured.
  double correlation = 0;
  int places = 0;  ///< places with structure whose motion was measured
  Occlusions alongColumns;
  Occlusions alongRows;
  /// Neighbouring rows contradict each other, as in a serpentine scan.
  bool isInconsistent = false;
  /// The measured places of the middle view, or of one next to it if that is missing, in pixels of
  /// the original images.
  std::vector<PlaceMotion> motions;
  int middleRow = -1;  ///< row of that view in the files; -1 if nothing was measured
  int middleColumn = -1;
};

/// Whether content moves up or down, and little sideways, from one column or row of the files to
/// the next, which a row of cameras never shows.
bool hasVerticalParallax(const ViewOrder& order);

/// Finds the order of views. Throws only Cancelled and what `view` throws, if the images have one
/// size.
ViewOrder findViewOrder(const GreyGrid& grid, const Progress& progress = {});

}  // namespace hogelscope
