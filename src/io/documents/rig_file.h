// SPDX-License-Identifier: BSD-3-Clause
// Rig documents: the cameras of a display's views, for renderers outside this program.
#pragma once

#include <string>
#include <vector>

#include "core/cameras/view_rig.h"

namespace hogelscope {

/// Returns the JSON document {"cameras": [{name, u, v, position, fx, fy, cx, cy, res}]}: metres in
/// the display frame, and pixels, whose centres are at integers.
std::string rigText(const std::vector<RigCamera>& rig);

/// Returns a glTF document with the same cameras. glTF has no cameras whose axis is beside the
/// middle of the image: `extras` of a camera hold its intrinsics.
std::string rigGltf(const std::vector<RigCamera>& rig);

}  // namespace hogelscope
