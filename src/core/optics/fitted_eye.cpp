// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/fitted_eye.h"

#include <algorithm>

namespace hogelscope {

namespace {

/// One of the image's two axes. A point at x, z towards the eye is seen by an eye at (c, d) if
/// |x - c| ≤ (d - z)·tangent, so x + z·tangent ≤ c + d·tangent and z·tangent - x ≤ d·tangent - c.
struct Side {
  double tangent = 1;
  double most = -HUGE_VAL;   ///< the largest x + z·tangent
  double least = -HUGE_VAL;  ///< the largest z·tangent - x

  void add(double x, double z) {
    most = std::max(most, x + z * tangent);
    least = std::max(least, z * tangent - x);
  }
  [[nodiscard]] double middle() const { return (most - least) / 2; }
  [[nodiscard]] double distance() const { return (most + least) / (2 * tangent); }
};

}  // namespace

FittedEye fittedEye(const std::vector<Vec3>& points, const RigidTransform& frame,
                    const Vec2& tangents) {
  Side across{tangents.x};
  Side down{tangents.y};
  double nearest = -HUGE_VAL;
  double farthest = HUGE_VAL;
  for (const Vec3& point : points) {
    const double z = dot(point, frame.zAxis);
    across.add(dot(point, frame.xAxis), z);
    down.add(dot(point, frame.yAxis), z);
    nearest = std::max(nearest, z);
    farthest = std::min(farthest, z);
  }
  const double depth = nearest - farthest;
  const double away = std::max({across.distance(), down.distance(), nearest + depth / 2});
  const Vec3 axis = across.middle() * frame.xAxis + down.middle() * frame.yAxis;
  return {axis + away * frame.zAxis, axis + (nearest + farthest) / 2 * frame.zAxis};
}

}  // namespace hogelscope
