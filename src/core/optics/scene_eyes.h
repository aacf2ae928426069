// SPDX-License-Identifier: BSD-3-Clause
// Eyes of the 3-D scene: the one whose view is a texture of the panel, and those whose image is
// filled by given points; the rounding of places that are dragged there.
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

/// Returns panelState() with square pixels whose side is `pixel` metres, `longest` at most across
/// and down; none also if no light of the panel reaches the eye.
std::optional<CameraState> litPanelState(const PanelParams& display, const Vec3& eye, double pixel,
                                         int longest);

/// Returns the distance from a point of the world to the nearest point of the panel, in metres.
double distanceToPanel(const DisplayParams& display, const Vec3& point);

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

/// A parallel projection.
struct ParallelView {
  Vec3 target;
  double halfHeight = 0;
};

/// Returns the closest projection along the frame's z that contains all points. `aspect` is the
/// image's width by its height.
ParallelView fittedParallel(const std::vector<Vec3>& points, const RigidTransform& frame,
                            double aspect);

/// Rounds the coordinates of `place` that differ from those of `before` to the decimal place that
/// `resolution`, in the same unit, resolves.
Vec3 rounded(const Vec3& place, const Vec3& before, double resolution);

/// Returns s so that `origin` + s·`direction` is the point of this line that is nearest to the line
/// through `other` along `along`; 0 for parallel lines.
double nearestOnLine(const Vec3& origin, const Vec3& direction, const Vec3& other,
                     const Vec3& along);

}  // namespace hogelscope
