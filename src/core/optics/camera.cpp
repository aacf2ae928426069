// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace hogelscope {

namespace {

/// Returns the vector to the right; its length is the sine of the angle between forward and up.
Vec3 rightOf(const CameraParams& p) {
  return cross(normalise(p.lookat - p.eye), normalise(p.up));
}

RigidTransform frameOf(const CameraParams& p) {
  const Vec3 forward = normalise(p.lookat - p.eye);
  if (forward == Vec3{}) throw InputError("lookat", "is the eye itself: the camera looks nowhere");
  if (!hasFrame(p))
    throw InputError("up", p.up == Vec3{} ? "is zero: give the direction that is up in the picture"
                                          : "is parallel to the line from eye to lookat");
  const Vec3 right = normalise(rightOf(p));
  return {right, cross(forward, right), forward, p.eye};
}

double orElse(double value, double otherwise) {
  return value == notGiven ? otherwise : value;
}

Vec2 focalLengthOf(const CameraParams& p, const IntrinsicsParams& intrinsics) {
  if (intrinsics.isGiven()) return {intrinsics.fx, orElse(intrinsics.fy, intrinsics.fx)};
  const double f = p.res[1] / 2.0 / std::tan(radians(p.fov) / 2);
  return {f, f};
}

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

void describe(ParameterVisitor& v, CameraParams& p) {
  auto& [name, eye, lookat, up, fov, res, weight, time] = p;
  v.group("camera", "A camera state: where it stands, where it looks, what it takes.");
  v.field("name", name, "Names the state and its picture's file.");
  v.field("eye", eye, {-1e6, 1e6, 0.01}, "m", "The pinhole, in the world.");
  v.field({"lookat", "Look at"}, lookat, {-1e6, 1e6, 0.01}, "m",
          "A point in the middle of the picture.");
  v.field("up", up, {-1e6, 1e6, 0.1}, "", "The direction that is up in the picture.");
  v.field({"fov", "Field of view"}, fov, {0.01, 179.9, 0.1, false, 5, 120}, "°",
          "Vertical field of view; not used where intrinsics are given.");
  v.field({"res", "Resolution"}, res, {1, 16384, 1}, "px", "Width and height of the picture.");
  v.field("weight", weight, {0, 1e6, 0.1}, "", "How much the state counts in weighted means.");
  v.count(time != notGiven);
  v.field("time", time, {0, 1e6, 0.1, true, 0, 60}, "s",
          "When the state looks at a light field in time, from its first frame on; not given: at "
          "every frame.");
  v.count(true);
}

void describe(ParameterVisitor& v, IntrinsicsParams& p) {
  auto& [fx, fy, cx, cy] = p;
  v.group("intrinsics", "A calibrated camera's, instead of fov; pixel centres are at integers.");
  v.field({"fx", "Focal length, x"}, fx, {1e-3, 1e8, 1, true}, "px", "Focal length across.");
  v.field({"fy", "Focal length, y"}, fy, {1e-3, 1e8, 1, true}, "px",
          "Focal length down; left out: fx, square pixels.");
  v.field({"cx", "Centre, x"}, cx, {-1e6, 1e6, 1, true}, "px",
          "Where the axis meets the picture; left out: its middle.");
  v.field({"cy", "Centre, y"}, cy, {-1e6, 1e6, 1, true}, "px", "The same, from the top.");
}

void describe(ParameterVisitor& v, StereoParams& p) {
  auto& [ipd] = p;
  v.group("stereo", "Two eyes, to the left and right of the state's, which is then the head's.");
  v.field({"ipd", "Eye distance"}, ipd, {0, 1, 0.001, false, 0, 0.08}, "m",
          "Between the pupils: 0.063 for most people; 0: one eye.");
}

bool hasFrame(const CameraParams& p) {
  return length(rightOf(p)) > 1e-9;  // below this the roll is rounding noise
}

Camera::Camera(const CameraParams& params, const IntrinsicsParams& intrinsics)
    : m_worldFromCamera(frameOf(params)),
      m_focal(focalLengthOf(params, intrinsics)),
      m_centre{orElse(intrinsics.cx, (params.res[0] - 1) / 2.0),
               orElse(intrinsics.cy, (params.res[1] - 1) / 2.0)} {}

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

CameraParams facing(CameraParams camera, const RigidTransform& worldFromPanel) {
  constexpr double nearest = 0.01;
  Vec3 eye = worldFromPanel.inverse().point(camera.eye);
  if (eye.z < nearest) eye.z = std::max(-eye.z, nearest);
  camera.eye = worldFromPanel.point(eye);
  camera.lookat = worldFromPanel.origin;
  if (!hasFrame(camera)) camera.up = worldFromPanel.yAxis;
  if (!hasFrame(camera)) camera.up = worldFromPanel.xAxis;
  return camera;
}

}  // namespace hogelscope
