// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/state_list_edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/optics/state_name.h"

namespace hogelscope {

std::optional<std::size_t> stateNamed(const Session& session, const std::string& name) {
  const std::u32string folded = caseFolded(name);
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (caseFolded(session.cameras[k].camera.name) == folded) return k;
  return std::nullopt;
}

std::string freeName(const Session& session, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; stateNamed(session, name); ++number)
    name = wanted + " " + std::to_string(number);
  return name;
}

CameraState inFrontOf(const PanelParams& display) {
  // The distance of the paper's camera in units of its panel, or that of the views' cameras.
  const double longer = std::max(display.size[0], display.size[1]);
  const bool isConverging = display.viewingDistance > 0;
  const double distance = isConverging ? display.viewingDistance : 1.118 * longer;
  const RigidTransform worldFromDisplay = transformFromPose(display.position, display.orientation);
  CameraState state;
  state.camera.name = "View";
  state.camera.eye = worldFromDisplay.point({0, 0, distance});
  state.camera.lookat = display.position;
  state.camera.up = worldFromDisplay.yAxis;
  if (isConverging) {
    const double angle = 360 / std::numbers::pi * std::atan(longer / (2 * distance));
    state.camera.fov = std::clamp(std::ceil(100 * angle) / 100, 0.01, 170.0);
  }
  return state;
}

std::size_t addState(Session& session, CameraState state) {
  state.camera.name = freeName(session, state.camera.name);
  session.cameras.push_back(std::move(state));
  return session.cameras.size() - 1;
}

std::size_t duplicateState(Session& session, std::size_t index) {
  const std::size_t last = addState(session, session.cameras.at(index));
  moveStates(session, {last}, index + 1);
  return index + 1;
}

void removeStates(Session& session, const std::vector<std::size_t>& indices) {
  std::vector<CameraState> left;
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (std::ranges::find(indices, k) == indices.end()) left.push_back(session.cameras[k]);
  if (left.empty())
    throw InputError("cameras", "would have no state left, and a session needs one");
  session.cameras = std::move(left);
}

void moveStates(Session& session, const std::vector<std::size_t>& indices, std::size_t before) {
  std::vector<CameraState> moved;
  std::vector<CameraState> above;
  std::vector<CameraState> below;
  for (std::size_t k = 0; k < session.cameras.size(); ++k) {
    const bool isMoved = std::ranges::find(indices, k) != indices.end();
    (isMoved ? moved : k < before ? above : below).push_back(session.cameras[k]);
  }
  above.insert(above.end(), moved.begin(), moved.end());
  above.insert(above.end(), below.begin(), below.end());
  session.cameras = std::move(above);
}

std::size_t moveStateUp(Session& session, std::size_t index) {
  const std::size_t to = index > 0 ? index - 1 : 0;
  moveStates(session, {index}, to);
  return to;
}

std::size_t moveStateDown(Session& session, std::size_t index) {
  const std::size_t to = std::min(index + 1, session.cameras.size() - 1);
  moveStates(session, {index}, to + 1);
  return to;
}

void renameState(Session& session, std::size_t index, const std::string& name) {
  CameraState state = session.cameras.at(index);
  if (state.camera.name == name) return;
  state.camera.name = name;
  check(state, "cameras[" + std::to_string(index) + "]");
  if (stateNamed(session, name).value_or(index) != index)
    throw InputError("name", "\"" + name + "\" is another state's already");
  session.cameras[index] = state;
}

void mergeStates(Session& session, const std::vector<CameraState>& states) {
  for (const CameraState& state : states) addState(session, state);
}

}  // namespace hogelscope
