// SPDX-License-Identifier: BSD-3-Clause
// A glTF scene at a time of an animation.
#pragma once

#include <optional>
#include <vector>

#include "gltf_animation.h"
#include "gltf_nodes.h"
#include "gltf_skins.h"
#include "mesh.h"

namespace hogelscope::mesh {

/// The points and normals of a primitive as the file has them: in a node's frame, or bound to the
/// joints of a skin.
struct Part {
  std::size_t node = 0;  ///< its place
  std::size_t skin = 0;  ///< in Parts::skins, where the binding has joints
  Binding binding;
  Numbers points;
  Numbers normals;  ///< without values if it has none
};

/// A light in a node's frame, along its −z.
struct Lamp {
  std::size_t node;  ///< its place
  Light light;
};

/// All that is placed by nodes.
struct Parts {
  std::vector<Skin> skins;
  std::vector<Part> parts;
  std::vector<Lamp> lamps;
};

/// Appends the points and normals of a part for frames of the nodes, by place.
void place(const Part& part, const std::vector<Skin>& skins, const std::vector<Affine>& frames,
           Posture& posture);
/// Appends a light.
void place(const Lamp& lamp, const std::vector<Affine>& frames, Posture& posture);

class GltfMotion : public Motion {
 public:
  GltfMotion(GltfNodes nodes, GltfAnimation animation, Parts parts)
      : m_nodes(std::move(nodes)), m_animation(std::move(animation)), m_parts(std::move(parts)) {}

  [[nodiscard]] double duration() const override { return m_animation.duration(); }
  [[nodiscard]] Posture at(double seconds) const override;

 private:
  GltfNodes m_nodes;
  GltfAnimation m_animation;
  Parts m_parts;
};

}  // namespace hogelscope::mesh
