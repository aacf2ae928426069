// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

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
  const Json& spot = GltfData::part(object, "spot");
  const double outer =
      std::clamp(data.number(spot, "outerConeAngle", std::numbers::pi / 4), 0.0, std::numbers::pi);
  light.cosOuter = std::cos(outer);
  light.cosInner = std::cos(std::clamp(data.number(spot, "innerConeAngle", 0), 0.0, outer));
  return light;
}

}  // namespace

std::vector<Material> MaterialReader::read() {
  std::vector<Material> materials(1);
  const std::size_t count = m_data.listAt("materials").size();
  m_data.reading().take(double(count + 1) * sizeof(Material));
  materials.reserve(count + 1);
  for (std::size_t k = 0; k < count; ++k) materials.push_back(material(k));
  return materials;
}

Material MaterialReader::material(std::size_t index) {
  const Json& object = m_data.entry("materials", index);
  const Json& surface = GltfData::part(object, "pbrMetallicRoughness");
  const Json& extensions = GltfData::part(object, "extensions");
  Material material;
  const auto clamped = [&](const std::vector<double>& colour, Linear& into, double most) {
    for (std::size_t c = 0; c < 3 && !colour.empty(); ++c)
      into[c] = float(std::clamp(colour[c], 0.0, most));
  };
  clamped(m_data.list(surface, "baseColorFactor", 4), material.colour, 1);
  material.layer = m_layers.layerOf(GltfData::part(surface, "baseColorTexture"));
  material.isUnlit = extensions.contains("KHR_materials_unlit");
  if (!material.isUnlit) {  // unlit materials emit nothing
    clamped(m_data.list(object, "emissiveFactor", 3), material.emission, 1);
    const double strength = m_data.number(
        GltfData::part(extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
    for (float& light : material.emission)
      light = float(std::clamp(double(light) * strength, 0.0, 1e30));
    if (material.emission != Linear{})
      material.glow = m_layers.layerOf(GltfData::part(object, "emissiveTexture"));
  }
  note(object, surface);
  return material;
}

void MaterialReader::note(const Json& object, const Json& surface) {
  for (const char* name : {"normalTexture", "occlusionTexture"})
    if (object.contains(name)) m_others.insert(name);
  if (surface.contains("metallicRoughnessTexture")) m_others.insert("metallicRoughnessTexture");
  const auto mode = object.find("alphaMode");
  if (mode != object.end() && *mode != "OPAQUE") m_others.insert("alphaMode");
}

void MaterialReader::finish(Mesh& mesh) const {
  mesh.textures = m_layers.textures().decode();
  const std::vector<std::string>& files = m_layers.textures().files();
  mesh.files.insert(mesh.files.end(), files.begin(), files.end());
  const std::set<std::string>& others = m_others;
  if (!others.empty()) mesh.notes.push_back(leftOut("materials'", {others.begin(), others.end()}));
}

std::vector<Light> readLights(const GltfData& data) {
  const Json& extension =
      GltfData::part(GltfData::part(data.root(), "extensions"), "KHR_lights_punctual");
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
