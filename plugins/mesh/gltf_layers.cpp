// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_layers.h"

#include <cmath>

namespace hogelscope::mesh {

namespace {

Wrap wrapOf(double code) {
  if (code == 33071) return Wrap::clamp;
  return code == 33648 ? Wrap::mirror : Wrap::repeat;
}

/// Applies KHR_texture_transform: T·R·S of texture coordinates. The rotation is counter-clockwise
/// for v pointing down (KhronosGroup/glTF issue 1563: the matrix in the extension's first text is
/// wrong).
void transform(const GltfData& data, const Json& extension, Layer& layer) {
  const std::vector<double> offset = data.list(extension, "offset", 2);
  const std::vector<double> scale = data.list(extension, "scale", 2);
  const double angle = data.number(extension, "rotation", 0);
  const double across = scale.empty() ? 1 : scale[0];
  const double down = scale.empty() ? 1 : scale[1];
  layer.axes = {Vec2{across * std::cos(angle), -across * std::sin(angle)},
                Vec2{down * std::sin(angle), down * std::cos(angle)}};
  if (!offset.empty()) layer.origin = {offset[0], offset[1]};
}

}  // namespace

Layer GltfLayers::layerOf(const Json& info) {
  Layer layer;
  const std::size_t index = m_data.index(info, "index");
  if (index == GltfData::none) return layer;
  const Json& extension =
      GltfData::part(GltfData::part(info, "extensions"), "KHR_texture_transform");
  transform(m_data, extension, layer);
  if (m_data.number(extension, "texCoord", m_data.number(info, "texCoord", 0)) != 0)
    m_data.fail(named("textures", index), "only texture coordinates 0 can be used");
  const Json& texture = m_data.entry("textures", index);
  const std::size_t source = m_data.index(texture, "source");
  if (source == GltfData::none)
    m_data.fail(named("textures", index), "has no picture; use PNG or JPEG");
  const std::size_t sampler = m_data.index(texture, "sampler");
  if (sampler != GltfData::none) {
    const Json& wraps = m_data.entry("samplers", sampler);
    layer.wrap[0] = wrapOf(m_data.number(wraps, "wrapS", 10497));
    layer.wrap[1] = wrapOf(m_data.number(wraps, "wrapT", 10497));
  }
  layer.texture = pictureOf(source);
  return layer;
}

int GltfLayers::pictureOf(std::size_t image) {
  const Json& object = m_data.entry("images", image);
  const std::string name = named("images", image);
  const std::size_t view = m_data.index(object, "bufferView");
  if (view != GltfData::none)
    return m_textures.add("bufferView " + std::to_string(view),
                          {m_data.bufferView(view), m_data.file(), name});
  const auto found = object.find("uri");
  if (found == object.end() || !found->is_string())
    m_data.fail(name, "has neither a bufferView nor a uri");
  const auto& uri = found->get_ref<const std::string&>();
  if (!GltfData::isData(uri)) return m_textures.add(m_data.fileOf(uri, name));
  // Its bytes are taken from the JSON only the first time.
  const auto known = m_ofData.find(image);
  if (known != m_ofData.end()) return known->second;
  const int number =
      m_textures.add("image " + std::to_string(image),
                     {m_textures.keep(m_data.dataOf(uri, name)), m_data.file(), name});
  return m_ofData[image] = number;
}

}  // namespace hogelscope::mesh
