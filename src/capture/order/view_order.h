// SPDX-License-Identifier: BSD-3-Clause
// Finds by their content alone how views lie in a grid: which end of a row was taken from the left,
// which end of a column from the top, and by how much the middle depth moves.
// docs/formulas.md, Order of views.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// An 8-bit grey picture, row by row from the top.
struct GreyPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;
};

/// Views in the order of their files. `view` is called for a few of them, for some more than once.
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

/// Counts places where one surface hides another. In the right order the hiding one moves left (of
/// columns) or up (of rows) relative to the hidden one.
struct Occlusions {
  using Areas = std::bitset<64>;  ///< 8×8 parts of the picture
  int ordered = 0;                ///< as in the right order
  int reversed = 0;               ///< as in the reversed one
  Areas orderedAreas;             ///< that have such a place: one object alone may deceive
  Areas reversedAreas;

  [[nodiscard]] int count() const { return ordered + reversed; }
  [[nodiscard]] Occlusions backwards() const;
  Occlusions& operator+=(const Occlusions& more);
};

/// The motion of a place of the picture, in pixels from one view to the next along the files'
/// columns and rows: {x, y} each.
struct PlaceMotion {
  std::array<double, 2> at{};  ///< pixel
  std::array<double, 2> alongColumns{};
  std::array<double, 2> alongRows{};
};

struct ViewOrder {
  /// The files' rows are columns of cameras: exchange both first; all else here is said of the
  /// grid after that.
  bool isTransposed = false;
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  Sureness sureness = Sureness::unknown;
  /// The motion of the middle depth from one view to the next, in pixels, x along columns and y
  /// along rows, as the files count them.
  std::array<double, 2> middleMotion{0, 0};
  /// Of x along columns with y along rows: near +1 where both run the same way, near -1 where one
  /// is reversed. 0 where it was not measured.
  double correlation = 0;
  int places = 0;  ///< with structure, where the motion was measured
  Occlusions alongColumns;
  Occlusions alongRows;
  /// Neighbouring rows contradict each other, as in a grid that was taken to and fro.
  bool isInconsistent = false;
  /// The measured places of the view in the middle, or next to it if that is missing, of the
  /// pictures' own pixels.
  std::vector<PlaceMotion> motions;
  int middleRow = -1;  ///< where that view lies among the files; -1 if nothing was measured
  int middleColumn = -1;
};

/// Whether content moves up or down, and little sideways, from one column or row of the files to
/// the next: what a row of cameras never shows.
bool hasVerticalParallax(const ViewOrder& order);

/// Never throws for any pictures of one size; Cancelled, and what `view` throws.
ViewOrder findViewOrder(const GreyGrid& grid, const Progress& progress = {});

}  // namespace hogelscope
