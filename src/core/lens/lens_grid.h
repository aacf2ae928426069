// SPDX-License-Identifier: BSD-3-Clause
// What a lens does to a grid of straight lines, as points of the picture: for drawing it.
#pragma once

#include <array>
#include <vector>

#include "core/lens/lens_rays.h"

namespace hogelscope {

/// All points in pixels of the picture, whose pixel centres are at integers.
struct LensGrid {
  std::array<int, 2> res{};  ///< the picture's size; {0, 0}: nothing to draw
  /// Pieces of the grid's lines, as far as the lens is one-to-one.
  std::vector<std::vector<Vec2>> lines;
  /// The closed line around the axis within which the lens has rays, and at most as far away as the
  /// picture's farthest corner; empty where it has rays as far as that everywhere.
  std::vector<Vec2> fold;
};

/// The grid is square in the world; a pinhole camera would see ten squares in the picture's height.
/// Throws Cancelled.
LensGrid lensGrid(const LensKey& lens, const Progress& progress = {});

}  // namespace hogelscope
