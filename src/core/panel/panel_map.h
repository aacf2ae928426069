// SPDX-License-Identifier: BSD-3-Clause
// The map from the slopes of an eye's rays to the cells of the panel.
#pragma once

#include <array>

#include "core/base/geometry.h"

namespace hogelscope {

class Display;

/// Maps slopes (a, b) of rays from one eye to cells of an affine twin (Twin::isAffine), before its
/// hogels' moves and its map of directions.
struct AffineHits {
  /// i and j: a constant, and what they grow by for each unit of a, and of b.
  std::array<std::array<double, 3>, 2> place{};
  /// u and v: a constant, and what they grow by for each unit of their own slope, and for each
  /// hogel along their axis and across it.
  std::array<std::array<double, 4>, 2> direction{};
};

/// Gives the real-valued hogel (i, j) and direction (u, v) that a ray from one eye meets, from its
/// slopes a = dx/dz and b = dy/dz in the display frame: `constant` + `slope`·a for i and u, ·b for
/// j and v (docs/formulas.md, Hit). Where the hogels' lenses are not linear, u and v are the slopes
/// that the lenses take; of a twin that is not affine, and of a lens sheet, only `count` is of use.
/// The display that made the map must outlive it.
struct PanelMap {
  std::array<double, 4> constant{};  ///< i, j, u, v at slope 0
  std::array<double, 4> slope{};
  std::array<int, 4> count{};  ///< cells of each axis
  const Display* display = nullptr;
  Vec3 eye;             ///< in the display frame, metres
  AffineHits affine{};  ///< of a twin that is affine
};

}  // namespace hogelscope
