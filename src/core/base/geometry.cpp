// SPDX-License-Identifier: BSD-3-Clause
// Points, directions and rigid transforms, in double.
#include "core/base/geometry.h"

#include <cmath>
#include <numbers>

namespace hogelscope {

double length(const Vec3& a) {
  return std::hypot(a.x, a.y, a.z);
}

Vec3 normalise(const Vec3& a) {
  const double n = length(a);
  return n > 0 ? Vec3{a.x / n, a.y / n, a.z / n} : Vec3{};
}

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}

Vec3 RigidTransform::direction(const Vec3& d) const {
  return d.x * xAxis + d.y * yAxis + d.z * zAxis;
}

RigidTransform RigidTransform::inverse() const {
  RigidTransform inverse{
      {xAxis.x, yAxis.x, zAxis.x}, {xAxis.y, yAxis.y, zAxis.y}, {xAxis.z, yAxis.z, zAxis.z}, {}};
  inverse.origin = -1.0 * inverse.direction(origin);
  return inverse;
}

RigidTransform operator*(const RigidTransform& a, const RigidTransform& b) {
  return {a.direction(b.xAxis), a.direction(b.yAxis), a.direction(b.zAxis), a.point(b.origin)};
}

RigidTransform transformFromPose(const Vec3& position, const Vec3& orientationDegrees) {
  const double ax = radians(orientationDegrees.x);
  const double ay = radians(orientationDegrees.y);
  const double az = radians(orientationDegrees.z);
  const auto rotate = [&](Vec3 p) {
    p = {std::cos(ay) * p.x + std::sin(ay) * p.z, p.y, -std::sin(ay) * p.x + std::cos(ay) * p.z};
    p = {p.x, std::cos(ax) * p.y - std::sin(ax) * p.z, std::sin(ax) * p.y + std::cos(ax) * p.z};
    return Vec3{std::cos(az) * p.x - std::sin(az) * p.y, std::sin(az) * p.x + std::cos(az) * p.y,
                p.z};
  };
  return {rotate({1, 0, 0}), rotate({0, 1, 0}), rotate({0, 0, 1}), position};
}

}  // namespace hogelscope
