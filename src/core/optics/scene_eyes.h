// SPDX-License-Identifier: BSD-3-Clause
// Eyes of the 3-D scene: the one whose view is a texture of the panel, and one whose image is
// filled by given points.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/optics/session.h"

namespace hogelscope {

/// Returns the state whose image covers the panel exactly: pixel (x, y) of `res` shows what `eye`
/// (world, metres) sees at the middle of cell (x, y) of the panel. It is a pinhole without a PSF.
/// None if the eye is not in front of the panel.
std::optional<CameraState> panelState(const DisplayParams& display, const Vec3& eye,
                                      const std::array<int, 2>& res);

/// Returns the distance from a point of the world to the nearest point of the panel, in metres.
double distanceToPanel(const DisplayParams& display, const Vec3& point);

/// Where an eye is, seen from the middle of the panel.
struct EyePlace {
  double distance = 0;  ///< metres
  double angle = 0;     ///< degrees from the panel's normal, across; positive on the panel's right
};
EyePlace eyePlace(const DisplayParams& display, const Vec3& eye);

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
