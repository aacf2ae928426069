// SPDX-License-Identifier: BSD-3-Clause
// The two eyes of a state. The state is the head: its eye lies between the two.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

enum class Eye { left, right };

/// Returns "left" or "right".
std::string_view nameOf(Eye eye);

inline bool hasTwoEyes(const CameraState& state) {
  return state.stereo.ipd > 0;
}

/// Returns the state of one eye (docs/formulas.md, Stereo): "NAME/left" or "NAME/right", with half
/// of the head's weight and no `stereo`. Its axis is parallel to the head's, and its principal
/// point is shifted so that the panel's centre has no disparity. Throws InputError as Camera does.
CameraState eyeOf(const CameraState& head, const DisplayParams& display, Eye eye);

/// Returns both eyes of a state with `stereo`, the left one first; otherwise the state itself.
std::vector<CameraState> eyesOf(const CameraState& head, const DisplayParams& display);

/// Returns the session with the eyes of its states in place of them.
Session withEyes(Session session);

/// Returns the name of a state's files, without an ending: "NAME.left" for "NAME/left".
std::string fileNameOf(std::string state);

/// Returns the name of the state that an eye, "NAME/left", is of; that of any other state itself.
std::string headOf(const std::string& state);

}  // namespace hogelscope
