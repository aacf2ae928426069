// SPDX-License-Identifier: BSD-3-Clause
// The textures of a glTF file's materials.
#pragma once

#include <map>

#include "gltf_data.h"
#include "mesh.h"
#include "textures.h"

namespace hogelscope::mesh {

class GltfLayers {
 public:
  explicit GltfLayers(GltfData& data) : m_data(data), m_textures(data.reading()) {}

  /// Returns the layer of a textureInfo.
  [[nodiscard]] Layer layerOf(const Json& info);
  [[nodiscard]] const Textures& textures() const { return m_textures; }

 private:
  [[nodiscard]] int pictureOf(std::size_t image);

  GltfData& m_data;
  Textures m_textures;
  std::map<std::size_t, int> m_ofData;  ///< texture indices of the images in the JSON
};

}  // namespace hogelscope::mesh
