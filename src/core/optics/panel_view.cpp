// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/panel_view.h"

#include <algorithm>
#include <cmath>

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

double distanceToPanel(const DisplayParams& display, const Vec3& point) {
  const Vec3 p = transformFromPose(display.position, display.orientation).inverse().point(point);
  const auto beyond = [](double at, double side) { return std::max(0.0, std::abs(at) - side / 2); };
  return length({beyond(p.x, display.size[0]), beyond(p.y, display.size[1]), p.z});
}

}  // namespace hogelscope
