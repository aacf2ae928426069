// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/calibrated_camera.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/optics/state_name.h"

namespace hogelscope {

namespace {

/// Returns the focal length, px, of a picture whose side spans an angle in degrees.
double focalLengthOver(int side, double angle) {
  return side / 2.0 / std::tan(radians(angle) / 2);
}

/// Returns the side of a picture whose middle is a principal point's coordinate.
int sideAround(double centre) {
  constexpr double longest = 16384;  // as in the description of CameraParams
  return static_cast<int>(std::clamp(std::round(2 * centre) + 1, 1.0, longest));
}

bool isWithin(double centre, int side) {
  return centre == notGiven || (centre > -0.5 && centre < side - 0.5);
}

double rounded9(double metres) {
  return std::round(metres * 1e9) / 1e9 + 0.0;  // no -0
}

Vec3 rounded9(const Vec3& p) {
  return {rounded9(p.x), rounded9(p.y), rounded9(p.z)};
}

/// Sets eye, look-at and up, rounded to nanometres, so that they do not depend on a machine's sine.
void stand(CameraParams& camera, const RigidTransform& worldFromCamera, const Vec3& middle) {
  constexpr double nearest = 1e-3;
  const auto& [right, down, forward, eye] = worldFromCamera;
  const double along = dot(middle - eye, forward);
  camera.eye = rounded9(eye);
  camera.lookat = rounded9(eye + (along > nearest ? along : 1) * forward);
  camera.up = rounded9(-1.0 * down);
}

/// Gives names to states that differ from each other and from others.
class StateNames {
 public:
  explicit StateNames(const std::vector<CameraState>& others) {
    for (const CameraState& state : others) m_taken.insert(caseFolded(state.camera.name));
  }

  std::string take(const std::string& wanted) {
    const std::string name = isName(wanted) ? wanted : "camera";
    std::string own = name;
    int& number = m_last[name];
    if (number == 0) number = 1;
    while (!m_taken.insert(caseFolded(own)).second) own = name + " " + std::to_string(++number);
    return own;
  }

 private:
  static bool isName(const std::string& name) {
    try {
      checkStateName(name, "");
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  std::set<std::u32string> m_taken;
  std::map<std::string, int> m_last;
};

}  // namespace

Calibration completed(Calibration calibration, const std::array<int, 2>& shown) {
  auto& [k, distortion, res, fov] = calibration;
  const bool hasAngles = !k.isGiven();
  if (!res) {
    res = shown;
    if (!isWithin(k.cx, shown[0]) || !isWithin(k.cy, shown[1]))
      res = {k.cx == notGiven ? shown[0] : sideAround(k.cx),
             k.cy == notGiven ? shown[1] : sideAround(k.cy)};
    if (hasAngles && fov[0] != notGiven && fov[1] != notGiven)  // pixels are square
      (*res)[0] = sideAround(
          (shown[1] * std::tan(radians(fov[0]) / 2) / std::tan(radians(fov[1]) / 2) - 1) / 2);
  }
  if (!hasAngles) return calibration;
  if (fov[0] != notGiven) k.fx = focalLengthOver((*res)[0], fov[0]);
  if (fov[1] != notGiven) k.fy = focalLengthOver((*res)[1], fov[1]);
  if (!k.isGiven()) k.fx = k.fy;
  return calibration;
}

IntrinsicsParams scaled(IntrinsicsParams intrinsics, double scale) {
  for (double* focal : {&intrinsics.fx, &intrinsics.fy})
    if (*focal != notGiven) *focal *= scale;
  for (double* centre : {&intrinsics.cx, &intrinsics.cy})  // a pixel's middle is a whole number
    if (*centre != notGiven) *centre = (*centre + 0.5) * scale - 0.5;
  return intrinsics;
}

void apply(const Calibration& calibration, CameraState& state) {
  const Calibration own = completed(calibration, state.camera.res);
  if (own.intrinsics.isGiven()) state.intrinsics = own.intrinsics;
  state.distortion = own.distortion;
  state.camera.res = *own.res;
}

std::vector<CameraState> statesOf(const CalibratedCameras& cameras, const CameraState& model,
                                  const Vec3& middle, const std::vector<CameraState>& others) {
  const RigidTransform worldFromModel = Camera(model.camera, model.intrinsics).worldFromCamera();
  StateNames names(others);
  std::vector<CameraState> states;
  states.reserve(cameras.cameras.size());
  for (const auto& [name, calibration, pose] : cameras.cameras) {
    CameraState state = model;
    state.camera.name = names.take(name);
    if (pose) stand(state.camera, cameras.isRig ? worldFromModel * *pose : *pose, middle);
    apply(calibration, state);
    check(state, state.camera.name);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace hogelscope
