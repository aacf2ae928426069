// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/view_rig.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

std::string padded(int number, int count) {
  const std::string text = std::to_string(number);
  const std::size_t digits = std::max<std::size_t>(std::to_string(count - 1).size(), 3);
  return std::string(digits - text.size(), '0') + text;
}

}  // namespace

std::string viewName(const LightFieldSize& size, int u, int v) {
  return padded(v, size.dv) + "_" + padded(u, size.du);
}

std::vector<RigCamera> rigOf(const PanelParams& display) {
  const double distance = display.viewingDistance;
  if (distance == notGiven)
    throw InputError(
        "lightField.viewingDistance",
        "is not given, so all rays of a view are parallel and no camera has them: "
        "--set lightField.viewingDistance=0.6 for cameras 0.6 m in front of the panel");
  const Display panel(display);
  const LightFieldSize& size = panel.size();
  constexpr double most = 1e6;  // cameras of about a gigabyte of memory
  if (double(size.du) * size.dv > most)
    throw InputError("display.directions", pairText(size.du, size.dv) +
                                               " views are more than a million cameras, the "
                                               "most that a rig has");
  const Vec2 pixel{display.size[0] / size.nx, display.size[1] / size.ny};
  const Vec2 middle{0.5 * (size.nx - 1), 0.5 * (size.ny - 1)};
  std::vector<RigCamera> rig;
  for (int v = 0; v < size.dv; ++v) {
    for (int u = 0; u < size.du; ++u) {
      const Vec2 slopes = panel.slopes(u + 0.5, v + 0.5);
      const Vec2 place{distance * slopes.x, distance * slopes.y};
      CameraState state;
      state.camera.name = viewName(size, u, v);
      state.camera.eye = {place.x, place.y, distance};
      state.camera.lookat = {place.x, place.y, 0};
      state.camera.res = {size.nx, size.ny};
      state.intrinsics = {distance / pixel.x, distance / pixel.y, middle.x + place.x / pixel.x,
                          middle.y - place.y / pixel.y};
      rig.push_back({u, v, state});
    }
  }
  return rig;
}

}  // namespace hogelscope
