// SPDX-License-Identifier: BSD-3-Clause
// A grid of straight lines as a lens images it, for drawings.
#pragma once

#include <array>
#include <vector>

#include "core/lens/lens_rays.h"

namespace hogelscope {

/// Points are in pixels of the image, with pixel centres at integers.
struct LensGrid {
  std::array<int, 2> res{};  ///< the image's size; {0, 0}: nothing to draw
  /// Pieces of the grid's lines, as far as the lens is one-to-one.
  std::vector<std::vector<Vec2>> lines;
  /// The closed line around the axis within which the lens has rays, at most as far away as the
  /// image's farthest corner; empty if it has rays up to there in every direction.
  std::vector<Vec2> fold;
};

/// Makes a grid of squares, ten of which fill the height of a pinhole camera's image.
/// Throws Cancelled.
LensGrid lensGrid(const LensKey& lens, const Progress& progress = {});

}  // namespace hogelscope
