// SPDX-License-Identifier: BSD-3-Clause
// Materials, textures and lights of a glTF file.
#pragma once

#include "gltf_data.h"
#include "mesh.h"

namespace hogelscope::mesh {

/// Appends the file's materials, and their textures, after the one that primitives without a
/// material have.
void readMaterials(GltfData& data, Mesh& mesh);

/// Returns the lights that nodes name, at their own origin.
std::vector<Light> readLights(const GltfData& data);

}  // namespace hogelscope::mesh
