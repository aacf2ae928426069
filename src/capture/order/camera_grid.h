// SPDX-License-Identifier: BSD-3-Clause
// Finds the rows and columns in which the cameras of a capture stood, from their poses. A guess is
// never made: cameras that do not fill a regular grid are refused with a reason.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace hogelscope {

struct CameraGrid {
  int columns = 0;  ///< 0: the cameras stand in no grid
  int rows = 0;
  /// The camera in each cell, row by row from the top left one, as the cameras see right and down.
  std::vector<std::size_t> cameras;
  /// The distance of neighbours across and down, in the poses' unit; 0 along a single line.
  std::array<double, 2> spacing{0, 0};
  Vec3 forward;         ///< the mean direction of view, in the poses' world
  std::string refusal;  ///< why they stand in no grid; "" if they do
};

/// Finds the grid of cameras by their poses, worldFromCamera with axes right, down, forward. They
/// must look the same way, within 5°, across and down the grid within 5° too, and stand within a
/// tenth of the spacing at the points of a plane lattice, one at each point of a rectangle.
CameraGrid cameraGridOf(const std::vector<RigidTransform>& poses);

}  // namespace hogelscope
