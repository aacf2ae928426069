// SPDX-License-Identifier: BSD-3-Clause
// Skins of a glTF file: points that follow several nodes, its joints.
#pragma once

#include <cstdint>
#include <vector>

#include "gltf_nodes.h"

namespace hogelscope::mesh {

struct Skin {
  std::vector<std::size_t> joints;  ///< places of nodes
  std::vector<Affine> toJoint;      ///< from the skin's frame at rest to each joint's
};

/// The joints that a primitive's points follow: `each` of them for a point, with weights that sum
/// to 1.
struct Binding {
  std::size_t each = 0;
  std::vector<std::uint32_t> joints;  ///< of the skin
  std::vector<float> weights;
};

/// Reads a skin by its number. Throws if a joint is not in the scene.
Skin readSkin(const GltfData& data, const GltfNodes& nodes, std::size_t skin);

/// Returns the memory of readBinding().
double bytesOfBinding(const GltfData& data, const Json& attributes);

/// Reads the attributes JOINTS_n and WEIGHTS_n of a primitive; `each` is 0 without them. Weights of
/// a point that are all 0 become 1 for its first joint.
Binding readBinding(const GltfData& data, const Json& attributes, std::size_t points,
                    const Skin& skin);

/// Returns the frames that points of the skin have, by joint, from the frames of the nodes.
std::vector<Affine> jointFrames(const Skin& skin, const std::vector<Affine>& frames);

/// Returns the frame of a point: the weighted mean of its joints' (glTF 2.0, section 3.7.3.3).
Affine frameOf(const Binding& binding, std::size_t point, const std::vector<Affine>& jointFrames);

}  // namespace hogelscope::mesh
