// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/scene_eyes.h"

#include <algorithm>
#include <cmath>

#include "core/panel/viewing_zone.h"

namespace hogelscope {

/// The image plane is parallel to the panel, so a pixel's point on the panel is affine in its
/// point on the sensor: X = ex + ez·(px - cx)/fx, Y = ey - ez·(py - cy)/fy.
std::optional<CameraState> panelState(const DisplayParams& display, const Vec3& eye,
                                      const std::array<int, 2>& res) {
  const RigidTransform worldFromDisplay = transformFromPose(display.position, display.orientation);
  const Vec3 e = worldFromDisplay.inverse().point(eye);
  if (!(e.z > 0)) return std::nullopt;
  const auto [width, height] = display.size;
  CameraState state;
  state.camera.name = "panel";
  state.camera.eye = eye;
  state.camera.lookat = eye - worldFromDisplay.zAxis;
  state.camera.up = worldFromDisplay.yAxis;
  state.camera.res = res;
  state.intrinsics = {e.z * res[0] / width, e.z * res[1] / height,
                      (e.x / width + 0.5) * res[0] - 0.5, (0.5 - e.y / height) * res[1] - 0.5};
  return state;
}

std::optional<CameraState> litPanelState(const PanelParams& display, const Vec3& eye, double pixel,
                                         int longest) {
  if (shareSeenFrom(display, eye) == 0) return std::nullopt;
  const auto pixels = [&](double side) {
    return int(std::clamp(side / pixel, 1.0, double(longest)));
  };
  return panelState(display, eye, {pixels(display.size[0]), pixels(display.size[1])});
}

double distanceToPanel(const DisplayParams& display, const Vec3& point) {
  const Vec3 p = transformFromPose(display.position, display.orientation).inverse().point(point);
  const auto beyond = [](double at, double side) { return std::max(0.0, std::abs(at) - side / 2); };
  return length({beyond(p.x, display.size[0]), beyond(p.y, display.size[1]), p.z});
}

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

ParallelView fittedParallel(const std::vector<Vec3>& points, const RigidTransform& frame,
                            double aspect) {
  Vec3 least{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 most = -1.0 * least;
  for (const Vec3& p : points) {
    const Vec3 at{dot(p, frame.xAxis), dot(p, frame.yAxis), dot(p, frame.zAxis)};
    least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y), std::max(most.z, at.z)};
  }
  return {frame.direction(0.5 * (least + most)),
          std::max(most.y - least.y, (most.x - least.x) / aspect) / 2};
}

Vec3 rounded(const Vec3& place, const Vec3& before, double resolution) {
  const double perUnit = std::pow(10, -std::floor(std::log10(resolution)));
  const auto round = [perUnit](double x, double old) {
    const bool isSame = std::abs(x - old) * perUnit < 1e-6;  // but for rounding errors
    return isSame ? old : std::round(x * perUnit) / perUnit;
  };
  return {round(place.x, before.x), round(place.y, before.y), round(place.z, before.z)};
}

double nearestOnLine(const Vec3& origin, const Vec3& direction, const Vec3& other,
                     const Vec3& along) {
  const Vec3 normal = cross(direction, along);
  const double square = dot(normal, normal);
  return square > 0 ? dot(cross(other - origin, along), normal) / square : 0;
}

}  // namespace hogelscope
