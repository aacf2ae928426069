// SPDX-License-Identifier: BSD-3-Clause
// The light incident on a point.
#pragma once

#include <optional>

#include "mesh.h"

namespace hogelscope::mesh {

/// Light incident on a point, as the brightness of a white surface facing it; 1 is white.
struct Arriving {
  Linear strength{};
  Vec3 way;                  ///< to the lamp, or towards it if isDirection
  bool isDirection = false;  ///< the lamp has no position
};

/// Returns the light of one lamp at a point, both in the display frame; none outside its cone or
/// range. A surface with an illuminance of E lux has the brightness E/π. Distances are in the
/// file's units, which are `unit` metres long, so that a scaled scene looks the same.
std::optional<Arriving> lightAt(const Light& light, const Vec3& point, double unit);

}  // namespace hogelscope::mesh
