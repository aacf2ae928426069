// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/gltf_cameras.h"

#include <cmath>

#include "core/optics/camera.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

/// Returns the node of a camera, which in glTF looks along its -z with +y up.
Json cameraNode(const CameraState& state, std::size_t index) {
  const auto [right, down, forward, eye] = Camera(state.camera, state.intrinsics).worldFromCamera();
  const Vec3 up = -1.0 * down;
  const Vec3 back = -1.0 * forward;
  return {{"name", state.camera.name},
          {"camera", index},
          {"matrix",
           {right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, back.x, back.y, back.z, 0, eye.x,
            eye.y, eye.z, 1}}};
}

Json cameraOf(const CameraState& state) {
  const auto [width, height] = state.camera.res;
  const Vec2 focal = Camera(state.camera, state.intrinsics).focalLength();
  const double nearest = 1e-3;  // metres
  Json camera{{"name", state.camera.name},
              {"type", "perspective"},
              {"perspective",
               {{"yfov", 2 * std::atan(height / 2.0 / focal.y)},
                {"aspectRatio", width / focal.x * focal.y / height},
                {"znear", nearest}}}};
  if (!state.intrinsics.isGiven()) return camera;
  const Vec2 centre = Camera(state.camera, state.intrinsics).centre();
  camera["extras"] = {{"fx", focal.x},
                      {"fy", focal.y},
                      {"cx", centre.x},
                      {"cy", centre.y},
                      {"res", {width, height}}};
  return camera;
}

}  // namespace

std::string withCameras(const std::string& gltf, const std::vector<std::string>& meshNames,
                        const std::vector<CameraState>& states) {
  Json root = Json::parse(gltf);
  Json nodes = Json::array();
  Json cameras = Json::array();
  for (const std::string& name : meshNames)
    nodes.push_back({{"name", name}, {"mesh", nodes.size()}});
  for (const CameraState& state : states) {
    if (!hasFrame(state.camera)) continue;
    nodes.push_back(cameraNode(state, cameras.size()));
    cameras.push_back(cameraOf(state));
  }
  Json all = Json::array();
  for (std::size_t k = 0; k < nodes.size(); ++k) all.push_back(k);
  root["nodes"] = nodes;
  root["scenes"] = Json::array({{{"nodes", all}}});
  root["scene"] = 0;
  root["cameras"] = cameras;
  if (cameras.empty()) root.erase("cameras");
  return root.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hogelscope
