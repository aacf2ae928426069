// SPDX-License-Identifier: BSD-3-Clause
// A certificate of a lens in a narrow sector around the centre: one march along the radius
// certifies it nearly up to its fold, and gives the distance from which on there is no ray.
#pragma once

#include <limits>

#include "core/optics/distortion.h"

namespace hogelscope {

/// The certified facts of a sector's distorted points. Distances from the centre, in units of the
/// plane z = 1.
struct LensSector {
  double ideal = 0;      ///< every root nearer than this is the right one
  double distorted = 0;  ///< all points nearer than this have such a root
  double dark = std::numeric_limits<double>::infinity();  ///< no point from here outwards has a ray
};

/// Certifies the directions within `halfWidth` of `angle`, in some microseconds. It is useful if
/// the tangential terms are small (docs/formulas.md, Distortion).
LensSector certifySector(const Distortion& lens, double angle, double halfWidth);

/// Returns a point near the root of a distorted point that has one by its sector.
Vec2 guessInSector(const Distortion& lens, const LensSector& sector, const Vec2& distorted);

}  // namespace hogelscope
