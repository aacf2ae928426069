// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/rig_file.h"

#include "io/documents/gltf_cameras.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

std::string rigText(const std::vector<RigCamera>& rig) {
  Json cameras = Json::array();
  for (const auto& [u, v, state] : rig) {
    const auto& [name, eye, lookat, up, fov, res, weight, time] = state.camera;
    const auto& [fx, fy, cx, cy] = state.intrinsics;
    cameras.push_back({{"name", name},
                       {"u", u},
                       {"v", v},
                       {"position", {eye.x, eye.y, eye.z}},
                       {"fx", fx},
                       {"fy", fy},
                       {"cx", cx},
                       {"cy", cy},
                       {"res", res}});
  }
  return Json({{"cameras", cameras}}).dump(2) + "\n";
}

std::string rigGltf(const std::vector<RigCamera>& rig) {
  std::vector<CameraState> states;
  for (const RigCamera& each : rig) states.push_back(each.state);
  return withCameras(R"({"asset": {"version": "2.0"}})", {}, states) + "\n";
}

}  // namespace hogelscope
