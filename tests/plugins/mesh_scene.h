// SPDX-License-Identifier: BSD-3-Clause
// Small scenes for tests of the mesh plugin: glTF documents built in parts, PNGs, and a MeshSource
// opened like in the program.
#pragma once

#include <spng.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <cstdlib>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh_reader.h"
#include "mesh_source.h"

namespace hogelscope::test {

using Json = nlohmann::json;

inline void writeFile(const std::string& path, const std::string& bytes) {
  QFile file(QString::fromStdString(path));
  file.remove();  // overwriting takes the file system a hundred times as long
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), qint64(bytes.size())) < 0)
    throw std::runtime_error(path + ": cannot be written");
}

template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Returns a PNG of 8-bit RGB.
inline std::string makePng(std::uint32_t width, std::uint32_t height,
                           const std::vector<std::uint8_t>& rgb, bool isInterlaced = false) {
  spng_ctx* png = spng_ctx_new(SPNG_CTX_ENCODER);
  const auto interlace = std::uint8_t(isInterlaced ? SPNG_INTERLACE_ADAM7 : SPNG_INTERLACE_NONE);
  spng_ihdr header{width, height, 8, SPNG_COLOR_TYPE_TRUECOLOR, 0, 0, interlace};
  spng_set_option(png, SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_ihdr(png, &header);
  if (spng_encode_image(png, rgb.data(), rgb.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE) != 0)
    throw std::runtime_error("the PNG cannot be made");
  std::size_t size = 0;
  int error = 0;
  void* buffer = spng_get_png_buffer(png, &size, &error);
  std::string bytes(static_cast<const char*>(buffer), size);
  std::free(buffer);
  spng_ctx_free(png);
  return bytes;
}

/// Builds a glTF document; `json` may be changed before it is written.
class Gltf {
 public:
  Gltf() {
    json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
    json["scenes"] = {{{"nodes", Json::array()}}};
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"})
      json[list] = Json::array();
  }

  int view(const std::string& bytes) {
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary += bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
    return int(json["bufferViews"].size()) - 1;
  }
  template <class T>
  int accessor(const std::vector<T>& values, int componentType, const char* type, int components) {
    json["accessors"].push_back({{"bufferView", view(bytesOf(values))},
                                 {"componentType", componentType},
                                 {"count", values.size() / std::size_t(components)},
                                 {"type", type}});
    return int(json["accessors"].size()) - 1;
  }
  /// Adds triangles of these points, in order, as a node. Returns the node for changes.
  Json& triangles(const std::vector<float>& points, int material = -1) {
    Json primitive{{"attributes", {{"POSITION", accessor(points, 5126, "VEC3", 3)}}}};
    if (material >= 0) primitive["material"] = material;
    json["meshes"].push_back({{"primitives", {primitive}}});
    return node({{"mesh", json["meshes"].size() - 1}});
  }
  /// Adds the rectangle between two corners at a depth, with uv 0 … 1 from its top left.
  Json& card(float left, float bottom, float right, float top, float z, int material = -1) {
    Json& added = triangles({left, bottom, z, right, bottom, z, right, top, z,  //
                             left, bottom, z, right, top, z, left, top, z},
                            material);
    const std::vector<float> uv{0, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0, 0};
    lastAttributes()["TEXCOORD_0"] = accessor(uv, 5126, "VEC2", 2);
    return added;
  }
  Json& lastAttributes() { return json["meshes"].back()["primitives"][0]["attributes"]; }
  Json& node(Json object) {
    json["nodes"].push_back(std::move(object));
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    return json["nodes"].back();
  }
  int material(double r, double g, double b, bool isUnlit = false) {
    Json object{{"pbrMetallicRoughness", {{"baseColorFactor", {r, g, b, 1}}}}};
    if (isUnlit) object["extensions"]["KHR_materials_unlit"] = Json::object();
    json["materials"].push_back(object);
    return int(json["materials"].size()) - 1;
  }
  /// Adds a material with an image.
  int textured(const std::string& png, int wrapS = 10497, int wrapT = 10497) {
    json["images"].push_back({{"mimeType", "image/png"}, {"bufferView", view(png)}});
    json["samplers"].push_back({{"wrapS", wrapS}, {"wrapT", wrapT}});
    const std::size_t last = json["images"].size() - 1;
    json["textures"].push_back({{"source", last}, {"sampler", last}});
    const int added = material(1, 1, 1);
    json["materials"].back()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", last}};
    return added;
  }
  void light(Json light, Json placed) {
    Json& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(light));
    placed["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
    node(std::move(placed));
  }

  [[nodiscard]] std::string glb() const {
    Json whole = json;
    if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = whole.dump();
    text += std::string((4 - text.size() % 4) % 4, ' ');
    const auto words = [](std::vector<std::uint32_t> list) { return bytesOf(list); };
    return "glTF" + words({2, std::uint32_t(28 + text.size() + binary.size())}) +
           words({std::uint32_t(text.size()), 0x4E4F534A}) + text +
           words({std::uint32_t(binary.size()), 0x004E4942}) + binary;
  }

  Json json;
  std::string binary;
};

/// Sets parameters by name, like a session's reader.
class Setter : public ParameterVisitor {
 public:
  explicit Setter(const Json& values) : m_values(values) {}
  void group(std::string_view, std::string_view) override {}

 protected:
  void numbers(const Field& field, std::span<double> values, bool isList) override {
    const Json* found = find(field);
    for (std::size_t k = 0; found != nullptr && k < values.size(); ++k)
      values[k] = isList ? (*found)[k].get<double>() : found->get<double>();
  }
  void integers(const Field&, std::span<int>, bool) override {}
  void flag(const Field&, bool&) override {}
  void text(const Field& field, std::string& value) override {
    if (const Json* found = find(field)) value = found->get<std::string>();
  }
  void choice(const Field& field, int& index) override {
    const Json* found = find(field);
    for (std::size_t k = 0; found != nullptr && k < field.choices.size(); ++k)
      if (*found == std::string(field.choices[k])) index = int(k);
  }

 private:
  const Json* find(const Field& field) const {
    const auto found = m_values.find(std::string(field.name));
    return found == m_values.end() ? nullptr : &*found;
  }

  const Json& m_values;
};

struct Going : plugin::Progress {
  [[nodiscard]] bool go(double) const override { return true; }
};

/// The memory limit of the tests' scenes.
constexpr std::uint64_t memory = 1000000000;

/// A folder with files, and the source of one of them.
class Scene {
 public:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (m_folder.path() + "/").toStdString() + name;
  }
  void add(const std::string& name, const std::string& bytes) const {
    writeFile(path(name), bytes);
  }
  void open(Json parameters) {
    Setter setter(parameters);
    source.describe(setter);
    source.open(panel, {m_folder.path().toStdString(), 2, memory}, Going{});
  }
  [[nodiscard]] mesh::Mesh read(const std::string& name) const {
    return mesh::readMesh(path(name), memory, Going{});
  }
  /// Opens a document, or the file of that name.
  void open(const Gltf& gltf, Json parameters = Json::object()) {
    add("scene.glb", gltf.glb());
    parameters["file"] = "scene.glb";
    open(std::move(parameters));
  }
  /// Returns the error message of a file, without the folder; "" if it is read.
  std::string refusal(const std::string& name, const std::string& bytes) {
    add(name, bytes);
    return refusal(name);
  }
  std::string refusal(const std::string& name) {
    try {
      open({{"file", name}});
    } catch (const std::runtime_error& error) {
      std::string text = error.what();
      const std::string folder = path("");
      for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
        text.erase(at, folder.size());
      return text;
    }
    return {};
  }
  /// Returns the depth z of a ray's hit, NaN if it meets nothing.
  [[nodiscard]] double depth(const plugin::Ray& ray) const {
    double z = 0;
    (void)source.traceDepths({&ray, 1}, {&z, 1});
    return z;
  }
  [[nodiscard]] plugin::Colour see(const plugin::Ray& ray) const {
    plugin::Colour colour;
    source.trace({&ray, 1}, {&colour, 1});
    return colour;
  }
  /// Returns the colour seen along −z at a place of the panel.
  [[nodiscard]] plugin::Colour see(double x, double y) const { return see(down(x, y)); }
  [[nodiscard]] static plugin::Ray down(double x, double y) { return {x, y, 1, 0, 0, 10}; }

  mesh::MeshSource source;
  plugin::Panel panel{{0.5, 0.5}, {128, 128}, {20, 20}, {0.05, 0.05}};

 private:
  QTemporaryDir m_folder;
};

}  // namespace hogelscope::test
