// SPDX-License-Identifier: BSD-3-Clause
// The light that falls on a point.
#pragma once

#include <optional>

#include "mesh.h"

namespace hogelscope::mesh {

/// Light that arrives at a point: as strong as a white surface that faces it would look; 1 is
/// white.
struct Arriving {
  Linear strength{};
  Vec3 way;                  ///< to the lamp, or its direction
  bool isDirection = false;  ///< the lamp is at no place
};

/// Returns the light of one lamp at a point, both in the display frame, or nothing outside of its
/// cone or range. A surface under E lux looks as strong as E/π; distances count in the file's
/// units, which are `unit` metres long, so that a scaled scene looks the same.
std::optional<Arriving> lightAt(const Light& light, const Vec3& point, double unit);

}  // namespace hogelscope::mesh
