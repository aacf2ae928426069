// SPDX-License-Identifier: BSD-3-Clause
// Points, directions and rigid transforms in double precision.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

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
inline double length(const Vec3& a) {
  return std::hypot(a.x, a.y, a.z);
}
/// Scales to length 1, even if the square of the length overflows or underflows. Zero stays 0.
inline Vec3 normalise(const Vec3& a) {
  const double n = length(a);
  return n > 0 ? Vec3{a.x / n, a.y / n, a.z / n} : Vec3{};
}

inline double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}

/// A rigid transform, named target-from-source: `worldFromDisplay.point(p)` takes p from the
/// display frame to the world frame. The columns are the source's axes seen from the target.
struct RigidTransform {
  Vec3 xAxis{1, 0, 0};
  Vec3 yAxis{0, 1, 0};
  Vec3 zAxis{0, 0, 1};
  Vec3 origin;

  [[nodiscard]] Vec3 direction(const Vec3& d) const {
    return d.x * xAxis + d.y * yAxis + d.z * zAxis;
  }
  [[nodiscard]] Vec3 point(const Vec3& p) const { return origin + direction(p); }
  [[nodiscard]] RigidTransform inverse() const {
    RigidTransform inverse{
        {xAxis.x, yAxis.x, zAxis.x}, {xAxis.y, yAxis.y, zAxis.y}, {xAxis.z, yAxis.z, zAxis.z}, {}};
    inverse.origin = -1.0 * inverse.direction(origin);
    return inverse;
  }
};

/// Returns the transform that applies b first, then a: `c-from-b * b-from-a` is c-from-a.
inline RigidTransform operator*(const RigidTransform& a, const RigidTransform& b) {
  return {a.direction(b.xAxis), a.direction(b.yAxis), a.direction(b.zAxis), a.point(b.origin)};
}

/// Returns T(position) · Rz·Rx·Ry, angles in degrees: the order of vtkProp3D::SetOrientation
/// (docs/formulas.md, Display).
inline RigidTransform transformFromPose(const Vec3& position, const Vec3& orientationDegrees) {
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
