// SPDX-License-Identifier: BSD-3-Clause
// The position of an eye whose image is filled by given points, for the 3-D scene.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace hogelscope {

/// An eye and the point that it looks at, in the points' frame.
struct FittedEye {
  Vec3 eye;
  Vec3 target;  ///< in the middle of the points' depth
};

/// Returns the nearest eye whose image has all points, of which there is at least one. It is at
/// least half the points' depth away from the nearest one, which could otherwise be in the eye.
/// `frame` has the image's axes, right, up and towards the eye. `tangents` are those of half the
/// field of view, across and down.
FittedEye fittedEye(const std::vector<Vec3>& points, const RigidTransform& frame,
                    const Vec2& tangents);

}  // namespace hogelscope
