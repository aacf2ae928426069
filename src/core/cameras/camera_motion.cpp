// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hogelscope {

namespace {

constexpr double stepMetres = 0.01;
constexpr double stepDegrees = 2;

/// Rotates right-handed about a unit vector (Rodrigues' formula).
Vec3 rotated(const Vec3& v, const Vec3& axis, double degrees) {
  const double c = std::cos(radians(degrees));
  const double s = std::sin(radians(degrees));
  return c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
}

/// Limits a tilt, so that the view stays one degree from `up` and its opposite. A view that is
/// nearer already may only turn away.
double tiltLeft(const Vec3& forward, const Vec3& up, double degrees) {
  constexpr double nearest = 1;
  const double fromUp =
      std::atan2(length(cross(forward, up)), dot(forward, up)) * (180 / std::numbers::pi);
  const double wanted =
      std::clamp(fromUp - degrees, std::min(fromUp, nearest), std::max(fromUp, 180 - nearest));
  return fromUp - wanted;
}

CameraParams shifted(CameraParams camera, const Vec3& by) {
  camera.eye = camera.eye + by;
  camera.lookat = camera.lookat + by;
  return camera;
}

}  // namespace

double stepOf(Motion motion) {
  const bool isWay = motion == Motion::walk || motion == Motion::strafe || motion == Motion::rise;
  return isWay ? stepMetres : stepDegrees;
}

CameraParams moved(const CameraParams& camera, Motion motion, double amount) {
  const RigidTransform frame = Camera(camera).worldFromCamera();
  const Vec3& right = frame.xAxis;
  const Vec3& forward = frame.zAxis;
  const Vec3 up = normalise(camera.up);
  const Vec3 view = camera.lookat - camera.eye;
  CameraParams result = camera;
  switch (motion) {
    case Motion::walk:
      return shifted(camera, amount * forward);
    case Motion::strafe:
      return shifted(camera, amount * right);
    case Motion::rise:
      return shifted(camera, amount * up);
    case Motion::turn:
      result.lookat = camera.eye + rotated(view, up, -amount);
      break;
    case Motion::tilt:
      result.lookat = camera.eye + rotated(view, right, tiltLeft(forward, up, amount));
      break;
    case Motion::roll:
      result.up = rotated(camera.up, forward, amount);
      break;
    case Motion::orbitAcross:
      result.eye = camera.lookat - rotated(view, up, amount);
      break;
    case Motion::orbitUp:
      result.eye = camera.lookat - rotated(view, right, tiltLeft(forward, up, -amount));
      break;
  }
  return result;
}

}  // namespace hogelscope
