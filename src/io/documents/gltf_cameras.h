// SPDX-License-Identifier: BSD-3-Clause
// Cameras of states in glTF documents.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

/// Returns a glTF document whose nodes are its meshes, with these names, and a camera for each
/// state that has a frame. glTF has no principal points: a camera with intrinsics has them, and its
/// resolution, in `extras`. Distortion is not exported. The document is one that a library made:
/// damaged JSON throws the parser's exception.
std::string withCameras(const std::string& gltf, const std::vector<std::string>& meshNames,
                        const std::vector<CameraState>& states);

}  // namespace hogelscope
