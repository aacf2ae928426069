// SPDX-License-Identifier: BSD-3-Clause
// Points, directions and rigid transforms in double precision.
#pragma once

#include <array>

namespace hogelscope {

struct Vec2 {
  double x = 0;
  double y = 0;
  bool operator==(const Vec2&) const = default;
};

struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;
  bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator*(double s, const Vec3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vec3& a);
/// Scales to length 1, also where the square of the length would overflow or vanish. Zero stays 0.
Vec3 normalise(const Vec3& a);

double radians(double degrees);

/// A rigid transform, named target-from-source: `worldFromDisplay.point(p)` takes p from the
/// display frame to the world frame. The columns are the source's axes seen from the target.
struct RigidTransform {
  Vec3 xAxis{1, 0, 0};
  Vec3 yAxis{0, 1, 0};
  Vec3 zAxis{0, 0, 1};
  Vec3 origin;

  [[nodiscard]] Vec3 direction(const Vec3& d) const;
  [[nodiscard]] Vec3 point(const Vec3& p) const { return origin + direction(p); }
  [[nodiscard]] RigidTransform inverse() const;
};

/// Applies b first, then a: `c-from-b * b-from-a` is c-from-a.
RigidTransform operator*(const RigidTransform& a, const RigidTransform& b);

/// T(position) · Rz·Rx·Ry, angles in degrees: the order of vtkProp3D::SetOrientation
/// (docs/formulas.md, Display).
RigidTransform transformFromPose(const Vec3& position, const Vec3& orientationDegrees);

}  // namespace hogelscope
