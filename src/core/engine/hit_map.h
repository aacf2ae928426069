// SPDX-License-Identifier: BSD-3-Clause
// A view's map from the image plane to cells, and the cells that a batch of rays meets.
#pragma once

#include <array>
#include <cstdint>

#include "core/panel/display.h"

namespace hogelscope {

/// The number of rays in a batch, small enough for the first-level cache.
constexpr int batchSize = 128;

/// Names the finder of a map's cells: `any` asks the display, one ray after another, the others
/// work out what it would say, many at once. Of a unit (Twin::hasKernel) and of an affine one
/// (Twin::isAffine) the lenses are linear, as a design's are; a curved design's are not.
enum class Finder { any, design, curved, unit, affine, sheet };

/// Maps a point (x, y, 1) of the image plane to real-valued hogel and direction (docs/formulas.md,
/// Hit): the direction in the display frame is d = x·right + y·down + forward, its slopes are
/// d.x/d.z and d.y/d.z.
struct HitMap {
  std::array<double, 3> right{};
  std::array<double, 3> down{};
  std::array<double, 3> forward{};
  PanelMap panel;         ///< the map from slopes to cells
  bool isSingle = false;  ///< float arithmetic
  Finder finder = Finder::any;
};

/// A function that is linear over the image plane: for each unit of x, of y, and a constant.
using PlaneFunction = std::array<double, 3>;

/// Returns d.z times `constant` + `ofA`·d.x/d.z + `ofB`·d.y/d.z.
inline PlaneFunction timesZ(const HitMap& m, double constant, double ofA, double ofB) {
  const auto along = [&](const std::array<double, 3>& d) {
    return ofA * d[0] + ofB * d[1] + constant * d[2];
  };
  return {along(m.right), along(m.down), along(m.forward)};
}

/// The cells of a batch, and for interpolation the position in them: 0 at the cell's beginning, 1
/// at its end.
struct CellBatch {
  std::array<std::array<std::uint32_t, batchSize>, 4> cell;
  std::array<std::array<float, batchSize>, 4> place;
  std::array<std::uint8_t, batchSize> seen;
};

}  // namespace hogelscope
