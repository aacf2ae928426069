// SPDX-License-Identifier: BSD-3-Clause
// Where an eye has to be so that points fill its image, for the 3-D scene.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace hogelscope {

/// What an eye looks from and at, in the points' frame.
struct FittedEye {
  Vec3 eye;
  Vec3 target;  ///< in the middle of the points' depth
};

/// Returns the nearest eye whose image has all points, of which there is at least one. It keeps
/// half the points' depth away from the nearest, since a lone one could be in the eye. `frame` has
/// the image's axes, right, up and towards the eye. `tangents` are those of half the field of view,
/// across and down.
FittedEye fittedEye(const std::vector<Vec3>& points, const RigidTransform& frame,
                    const Vec2& tangents);

}  // namespace hogelscope
