// SPDX-License-Identifier: BSD-3-Clause
// Materials, textures and lights of a glTF file.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "gltf_layers.h"
#include "mesh.h"

namespace hogelscope::mesh {

class MaterialReader {
 public:
  explicit MaterialReader(GltfData& data) : m_data(data), m_layers(data) {}

  /// Returns the file's materials, after the one of primitives without a material. Their textures
  /// then have indices and are known to fit the memory.
  [[nodiscard]] std::vector<Material> read();
  /// Adds the textures, their files, and notes on properties of the materials that are not shown.
  void finish(Mesh& mesh) const;

 private:
  [[nodiscard]] Material material(std::size_t index);
  void note(const Json& object, const Json& surface);

  GltfData& m_data;
  GltfLayers m_layers;
  std::set<std::string> m_others;  ///< properties that are not shown
};

/// Returns the lights of nodes, at their own origin.
std::vector<Light> readLights(const GltfData& data);

}  // namespace hogelscope::mesh
