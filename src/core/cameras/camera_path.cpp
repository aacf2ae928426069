// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/camera_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/cameras/focus_stack.h"

namespace hogelscope {

namespace {

constexpr std::size_t longest = 1'000'000;  // pictures of a path

Vec3 lerp(const Vec3& a, const Vec3& b, double t) {
  return {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t), std::lerp(a.z, b.z, t)};
}

/// Opposite directions, which have no plane, are a roll about the view.
Vec3 upBetween(const CameraParams& from, const CameraParams& to, double t) {
  const Vec3 a = normalise(from.up);
  const Vec3 b = normalise(to.up);
  const double angle = t * std::atan2(length(cross(a, b)), dot(a, b));
  if (angle < 1e-9) return from.up;
  Vec3 side = b - dot(a, b) * a;
  if (length(side) < 1e-9) side = cross(from.lookat - from.eye, a);
  return std::cos(angle) * a + std::sin(angle) * normalise(side);
}

/// Of a camera with a field of view, the intrinsics that have the same effect.
IntrinsicsParams givenIntrinsics(const CameraState& state) {
  const Camera camera(state.camera, state.intrinsics);
  return {camera.focalLength().x, camera.focalLength().y, camera.centre().x, camera.centre().y};
}

/// A lens of Brown and Conrady is a rational one too; a fisheye is neither.
void mixLenses(DistortionParams& lens, const CameraState& to, double t) {
  const auto isFisheye = [](const DistortionParams& p) {
    return p.model == DistortionModel::fisheye;
  };
  if (isFisheye(lens) != isFisheye(to.distortion))
    throw InputError(to.camera.name,
                     "distortion.model: only one of two neighbouring states is a "
                     "fisheye: there is no lens between them");
  lens.model = std::max(lens.model, to.distortion.model);
  for (const LensCoefficient& k : coefficientsOf(DistortionModel::rational))
    lens.*k.value = std::lerp(lens.*k.value, to.distortion.*k.value, t);
}

/// std::lerp of equal numbers is exact, so equal lenses stay equal.
CameraState between(const CameraState& from, const CameraState& to, double t) {
  CameraState state = from;
  const auto mix = [t](double& value, double end) { value = std::lerp(value, end, t); };
  state.camera.eye = lerp(from.camera.eye, to.camera.eye, t);
  state.camera.lookat = lerp(from.camera.lookat, to.camera.lookat, t);
  state.camera.up = upBetween(from.camera, to.camera, t);
  mix(state.camera.fov, to.camera.fov), mix(state.camera.weight, to.camera.weight);
  if (from.intrinsics != to.intrinsics) {
    auto& [fx, fy, cx, cy] = state.intrinsics = givenIntrinsics(from);
    const IntrinsicsParams end = givenIntrinsics(to);
    mix(fx, end.fx), mix(fy, end.fy), mix(cx, end.cx), mix(cy, end.cy);
  }
  mix(state.pupil.diameter, to.pupil.diameter), mix(state.pupil.focus, to.pupil.focus);
  mix(state.stereo.ipd, to.stereo.ipd);
  mixLenses(state.distortion, to, t);
  mix(state.psf.sigma, to.psf.sigma);
  const double reach = std::lerp(from.psf.windowSize - 1, to.psf.windowSize - 1, t) / 2;
  state.psf.windowSize = 2 * int(std::lround(reach)) + 1;
  return state;
}

}  // namespace

std::vector<CameraState> statesAlong(const CameraPath& path, const Session& session,
                                     std::size_t current) {
  std::vector<CameraState> states = session.cameras;
  const bool isBetween = path.kind == PathKind::between;
  if (states.empty() || (isBetween && path.count > 0)) requireOneSize(states);
  const auto steps = std::size_t(path.count) + 1;
  const std::size_t size = isBetween ? (states.size() - 1) * steps + 1 : std::size_t(path.count);
  if (size > longest) throw InputError("cameras", "their path has more than a million pictures");
  if (isBetween) {
    states.resize(size);
    for (std::size_t k = 0; k < states.size(); ++k)
      states[k] = stateAt(session.cameras, double(k) / double(steps));
  } else if (path.kind == PathKind::focus) {
    const CameraState& state = session.cameras.at(current);
    states = focusStack(state, focusDistances(state, displayOf(session), path.count));
  } else {
    states.assign(size, session.cameras.at(current));
    for (std::size_t k = 0; k < states.size(); ++k)
      states[k].camera = turned(path.kind, states[k].camera, session.display,
                                path.degrees * ((double(k) + 0.5) / path.count - 0.5));
  }
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(states.size()).size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    states[k].camera.name = "frame_" + std::string(digits - number.size(), '0') + number;
  }
  return states;
}

CameraState stateAt(const std::vector<CameraState>& states, double position) {
  const auto index = std::size_t(std::clamp(position, 0.0, double(states.size() - 1)));
  const double t = position - double(index);
  return t > 0 && index + 1 < states.size() ? between(states[index], states[index + 1], t)
                                            : states[index];
}

CameraParams turned(PathKind kind, const CameraParams& camera, const DisplayParams& display,
                    double degrees) {
  if (kind == PathKind::orbit) return moved(camera, Motion::orbitAcross, degrees);
  const RigidTransform pose = transformFromPose(display.position, display.orientation);
  const RigidTransform turn = pose * transformFromPose({}, {0, degrees, 0}) * pose.inverse();
  CameraParams result = camera;
  result.eye = turn.point(camera.eye);
  result.lookat = turn.point(camera.lookat);
  result.up = turn.direction(camera.up);
  return result;
}

void requireOneSize(const std::vector<CameraState>& states) {
  if (states.empty()) throw InputError("cameras", "there is no state");
  for (const CameraState& state : states)
    if (state.camera.res != states.front().camera.res)
      throw InputError(state.camera.name,
                       "camera.res: differs from that of " + states.front().camera.name +
                           ": pictures between them, and those of a video, have one size");
}

}  // namespace hogelscope
