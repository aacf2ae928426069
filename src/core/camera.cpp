// SPDX-License-Identifier: BSD-3-Clause
// The pinhole camera of a state.
#include "core/camera.h"

#include <cmath>

#include "core/error.h"

namespace hogelscope {

namespace {

RigidTransform frameOf(const CameraParams& p) {
  const Vec3 forward = normalise(p.lookat - p.eye);
  if (forward == Vec3{}) throw InputError("lookat", "is the eye itself: the camera looks nowhere");
  const Vec3 right = cross(forward, normalise(p.up));
  // The sine of the angle between forward and up; below this the roll is rounding noise.
  if (!(length(right) > 1e-9))
    throw InputError("up", p.up == Vec3{} ? "is zero: give the direction that is up in the picture"
                                          : "is parallel to the line from eye to lookat");
  const Vec3 unitRight = normalise(right);
  return {unitRight, cross(forward, unitRight), forward, p.eye};
}

}  // namespace

void describe(ParameterVisitor& v, CameraParams& p) {
  auto& [name, eye, lookat, up, fov, res] = p;
  v.group("camera", "A camera state: where it stands, where it looks, what it takes.");
  v.field("name", name, "Names the state and its picture's file.");
  v.field("eye", eye, {-1e6, 1e6, 0.01}, "m", "The pinhole, in the world.");
  v.field("lookat", lookat, {-1e6, 1e6, 0.01}, "m", "A point in the middle of the picture.");
  v.field("up", up, {-1e6, 1e6, 0.1}, "", "The direction that is up in the picture.");
  v.field("fov", fov, {0.01, 179.9, 0.1}, "°", "Vertical field of view.");
  v.field("res", res, {1, 16384, 1}, "px", "Width and height of the picture.");
}

Camera::Camera(const CameraParams& params)
    : m_worldFromCamera(frameOf(params)),
      m_focal(params.res[1] / 2.0 / std::tan(radians(params.fov) / 2)),
      m_centre{(params.res[0] - 1) / 2.0, (params.res[1] - 1) / 2.0} {}

}  // namespace hogelscope
