// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/eyes.h"

#include <algorithm>
#include <utility>

namespace hogelscope {

std::string_view nameOf(Eye eye) {
  return eye == Eye::left ? "left" : "right";
}

CameraState eyeOf(const CameraState& head, const DisplayParams& display, Eye eye) {
  const Camera camera(head.camera, head.intrinsics);
  const RigidTransform& frame = camera.worldFromCamera();
  CameraState state = head;
  const double ipd = std::exchange(state.stereo, {}).ipd;
  const double right = (eye == Eye::left ? -0.5 : 0.5) * ipd;
  const Vec3 step = right * frame.xAxis;
  state.camera.name += "/" + std::string(nameOf(eye));
  state.camera.eye = state.camera.eye + step;
  state.camera.lookat = state.camera.lookat + step;
  state.camera.weight /= 2;
  const double depth = dot(display.position - head.camera.eye, frame.zAxis);
  const Vec2 focal = camera.focalLength();
  const Vec2 centre = camera.centre();
  // A panel behind the eyes cannot be converged on.
  const double shift = depth > 0 ? focal.x * right / depth : 0;
  state.intrinsics = {focal.x, focal.y, centre.x + shift, centre.y};
  return state;
}

std::vector<CameraState> eyesOf(const CameraState& head, const DisplayParams& display) {
  if (!hasTwoEyes(head)) return {head};
  return {eyeOf(head, display, Eye::left), eyeOf(head, display, Eye::right)};
}

Session withEyes(Session session) {
  std::vector<CameraState> eyes;
  for (const CameraState& state : session.cameras)
    for (CameraState& eye : eyesOf(state, session.display)) eyes.push_back(std::move(eye));
  session.cameras = std::move(eyes);
  return session;
}

std::string fileNameOf(std::string state) {
  std::ranges::replace(state, '/', '.');
  return state;
}

std::string headOf(const std::string& state) {
  return state.substr(0, state.find('/'));
}

}  // namespace hogelscope
