// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "errors.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

std::string named(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

/// The object that a member holds; an empty one if there is none.
const Json& part(const Json& object, const char* member) {
  static const Json nothing = Json::object();
  const auto found = object.find(member);
  return found != object.end() && found->is_object() ? *found : nothing;
}

Wrap wrapOf(double code) {
  if (code == 33071) return Wrap::clamp;
  return code == 33648 ? Wrap::mirror : Wrap::repeat;
}

/// Decodes each picture once, however many materials have it.
class Textures {
 public:
  Textures(GltfData& data, Mesh& mesh) : m_data(data), m_mesh(mesh) {}

  void apply(const Json& info, Material& material) {
    const std::size_t index = m_data.index(info, "index");
    if (index == GltfData::none) return;
    if (m_data.number(info, "texCoord", 0) != 0)
      m_data.fail(named("textures", index), "only texture coordinates 0 can be used");
    const Json& texture = m_data.entry("textures", index);
    const std::size_t source = m_data.index(texture, "source");
    if (source == GltfData::none)
      m_data.fail(named("textures", index), "has no picture; use PNG or JPEG");
    const std::size_t sampler = m_data.index(texture, "sampler");
    if (sampler != GltfData::none) {
      const Json& wraps = m_data.entry("samplers", sampler);
      material.wrap[0] = wrapOf(m_data.number(wraps, "wrapS", 10497));
      material.wrap[1] = wrapOf(m_data.number(wraps, "wrapT", 10497));
    }
    material.texture = pictureOf(source);
  }

 private:
  int pictureOf(std::size_t image) {
    const auto [found, isNew] = m_numbers.try_emplace(image, int(m_mesh.textures.size()));
    if (!isNew) return found->second;
    const Json& object = m_data.entry("images", image);
    const std::string name = named("images", image);
    const std::size_t view = m_data.index(object, "bufferView");
    const auto uri = object.find("uri");
    if (view == GltfData::none && (uri == object.end() || !uri->is_string()))
      m_data.fail(name, "has neither a bufferView nor a uri");
    const std::string bytes = view != GltfData::none
                                  ? std::string(m_data.bufferView(view))
                                  : m_data.resource(uri->get<std::string>(), name);
    m_mesh.textures.emplace_back(decodePicture(bytes, m_data.file(), name));
    m_texels += m_mesh.textures.back().size();
    if (m_texels > 1 << 27) m_data.fail("its textures", "have more than 134217728 pixels together");
    return found->second;
  }

  GltfData& m_data;
  Mesh& m_mesh;
  std::map<std::size_t, int> m_numbers;
  double m_texels = 0;
};

Light readLight(const GltfData& data, const Json& object, const std::string& name) {
  Light light;
  const auto type = object.find("type");
  const std::string kind =
      type != object.end() && type->is_string() ? type->get<std::string>() : "";
  if (kind != "directional" && kind != "point" && kind != "spot")
    data.fail(name + ".type", "must be directional, point or spot");
  light.kind = kind == "point"  ? Light::Kind::point
               : kind == "spot" ? Light::Kind::spot
                                : Light::Kind::directional;
  const double intensity = data.number(object, "intensity", 1);
  const std::vector<double> colour = data.list(object, "color", 3);
  for (std::size_t c = 0; c < 3; ++c)
    light.intensity[c] = float(std::clamp(intensity * (colour.empty() ? 1 : colour[c]), 0.0, 1e30));
  light.range = std::max(0.0, data.number(object, "range", 0));
  const Json& spot = part(object, "spot");
  const double outer =
      std::clamp(data.number(spot, "outerConeAngle", std::numbers::pi / 4), 0.0, std::numbers::pi);
  light.cosOuter = std::cos(outer);
  light.cosInner = std::cos(std::clamp(data.number(spot, "innerConeAngle", 0), 0.0, outer));
  return light;
}

}  // namespace

void readMaterials(GltfData& data, Mesh& mesh) {
  mesh.materials.emplace_back();
  const Json& root = data.root();
  if (!root.contains("materials")) return;
  Textures textures(data, mesh);
  for (std::size_t k = 0; k < root["materials"].size(); ++k) {
    const Json& object = data.entry("materials", k);
    const Json& surface = part(object, "pbrMetallicRoughness");
    Material material;
    const std::vector<double> colour = data.list(surface, "baseColorFactor", 4);
    for (std::size_t c = 0; c < 3 && !colour.empty(); ++c)
      material.colour[c] = float(std::clamp(colour[c], 0.0, 1.0));
    textures.apply(part(surface, "baseColorTexture"), material);
    material.isUnlit = part(object, "extensions").contains("KHR_materials_unlit");
    mesh.materials.push_back(material);
  }
}

std::vector<Light> readLights(const GltfData& data) {
  const Json& extension = part(part(data.root(), "extensions"), "KHR_lights_punctual");
  const auto found = extension.find("lights");
  std::vector<Light> lights;
  if (found == extension.end() || !found->is_array()) return lights;
  for (std::size_t k = 0; k < found->size(); ++k) {
    if (!(*found)[k].is_object()) data.fail(named("lights", k), "must be an object");
    lights.push_back(readLight(data, (*found)[k], named("lights", k)));
  }
  return lights;
}

}  // namespace hogelscope::mesh
