// SPDX-License-Identifier: BSD-3-Clause
// glTF 2.0: the scene's nodes with their meshes, skins and lights, at rest or with an animation.
// Morph targets are not applied, which is noted.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "errors.h"
#include "gltf_data.h"
#include "gltf_materials.h"
#include "gltf_motion.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

/// A primitive of a node.
struct Placed {
  const Json* primitive = nullptr;
  std::size_t node = 0;               ///< its place
  std::size_t skin = GltfData::none;  ///< the node's, in Parts::skins
};

/// The sizes of a primitive or of all of them.
struct Sizes {
  double points = 0;
  double triangles = 0;
  double numbers = 0;  ///< bytes used while they are read
  double kept = 0;     ///< bytes of those that an animation needs
};

class GltfReader {
 public:
  GltfReader(Reading& reading, const std::string& animation)
      : m_reading(reading), m_data(reading), m_nodes(m_data), m_materials(m_data) {
    if (!animation.empty()) m_animation.emplace(m_data, m_nodes, animation);
  }

  Mesh read() {
    m_mesh.materials = m_materials.read();
    m_lights = readLights(m_data);
    for (std::size_t place = 0; place < m_nodes.count(); ++place) readNode(place);
    measure();
    std::vector<NodePose> poses = m_nodes.rest();
    if (m_animation) m_animation->apply(0, poses);
    const std::vector<Affine> frames = m_nodes.frames(poses);
    for (const Lamp& lamp : m_parts.lamps) place(lamp, frames, m_mesh);
    for (std::size_t k = 0; k < m_primitives.size(); ++k) {
      m_reading.report(k, m_primitives.size());
      readPrimitive(m_primitives[k], frames);
    }
    m_mesh.fillAttributes();
    m_mesh.files = m_data.files();
    m_materials.finish(m_mesh);
    addNotes();
    if (m_animation)
      m_mesh.motion = std::make_shared<const GltfMotion>(
          std::move(m_nodes), std::move(*m_animation), std::move(m_parts));
    return std::move(m_mesh);
  }

 private:
  void readNode(std::size_t place) {
    const Json& node = m_data.entry("nodes", m_nodes.numberOf(place));
    const std::size_t mesh = m_data.index(node, "mesh");
    if (mesh != GltfData::none) {
      const Json& object = m_data.entry("meshes", mesh);
      const auto primitives = object.find("primitives");
      if (primitives == object.end() || !primitives->is_array())
        m_data.fail(named("meshes", mesh), "has no list of primitives");
      const std::size_t skin = m_data.index(node, "skin");
      if (skin != GltfData::none) m_parts.skins.push_back(readSkin(m_data, m_nodes, skin));
      for (const Json& primitive : *primitives)
        placePrimitive(primitive, place, skin == GltfData::none ? skin : m_parts.skins.size() - 1);
    }
    const auto extensions = node.find("extensions");
    if (extensions == node.end() || !extensions->is_object()) return;
    const auto lamp = extensions->find("KHR_lights_punctual");
    if (lamp != extensions->end() && lamp->is_object()) placeLight(*lamp, place);
  }

  void placeLight(const Json& lamp, std::size_t place) {
    const std::size_t index = m_data.index(lamp, "light");
    if (index >= m_lights.size()) m_data.fail("a node's light", "is not in the list of lights");
    m_parts.lamps.push_back({place, m_lights[index]});
  }

  void placePrimitive(const Json& primitive, std::size_t place, std::size_t skin) {
    if (!primitive.is_object() || !primitive.contains("attributes") ||
        !primitive["attributes"].is_object())
      m_data.fail("a primitive", "has no attributes");
    m_hasTargets = m_hasTargets || primitive.contains("targets");
    if (m_data.number(primitive, "mode", 4) < 4) {
      m_hasLines = true;
      return;
    }
    m_reading.take(2 * sizeof(Placed));
    m_primitives.push_back({&primitive, place, skin});
  }

  [[nodiscard]] Sizes sizesOf(const Placed& placed) const {
    const Json& primitive = *placed.primitive;
    const Json& attributes = primitive["attributes"];
    const std::size_t places = m_data.index(attributes, "POSITION");
    if (places == GltfData::none) m_data.fail("a primitive", "has no attribute POSITION");
    const auto rows = double(m_data.rows(places));
    const std::size_t indices = m_data.index(primitive, "indices");
    const double corners = indices == GltfData::none ? rows : double(m_data.rows(indices));
    const double step = m_data.number(primitive, "mode", 4) == 4 ? 3 : 1;
    Sizes sizes{rows, std::floor(corners / step), m_data.bytes(places)};
    for (const auto& [name, bytes] : attributeBytes)
      if (const std::size_t accessor = m_data.index(attributes, name); accessor != GltfData::none)
        sizes.numbers += m_data.bytes(accessor);
    const double binding = placed.skin == GltfData::none ? 0 : bytesOfBinding(m_data, attributes);
    sizes.numbers = std::max(sizes.numbers + binding, 2 * corners * sizeof(std::uint32_t));
    if (m_animation) sizes.kept = sizes.numbers + sceneBytesOfMotion * rows;
    return sizes;
  }

  /// Returns the bytes of a point with all attributes that any primitive has.
  [[nodiscard]] double bytesOfPoint() const {
    double sum = sizeof(Vec3) + sceneBytesOfPoint;
    for (const auto& [name, bytes] : attributeBytes)
      if (std::ranges::any_of(m_primitives, [name = name](const Placed& placed) {
            return (*placed.primitive)["attributes"].contains(name);
          }))
        sum += bytes;
    return sum;
  }

  /// Counts the memory of the whole scene before any of it is allocated.
  void measure() {
    Sizes whole;
    for (std::size_t k = 0; k < m_primitives.size(); ++k) {
      if (k % 1024 == 0) m_reading.poll();
      const Sizes sizes = sizesOf(m_primitives[k]);
      whole = {whole.points + sizes.points, whole.triangles + sizes.triangles,
               std::max(whole.numbers, sizes.numbers), whole.kept + sizes.kept};
    }
    if (whole.points > 3.0 * mostTriangles || whole.triangles > double(mostTriangles))
      m_data.fail("the scene", "stands for more than 33554432 triangles");
    constexpr double bytesOfTriangle =
        sizeof(Corners) + sizeof(std::uint32_t) + sceneBytesOfTriangle;
    // While a moving scene is built at another time, the last one is there.
    const double scenes = m_animation ? 2 : 1;
    m_reading.take(whole.numbers + whole.kept + whole.points * bytesOfPoint() +
                   whole.triangles * (bytesOfTriangle + (scenes - 1) * sceneBytesOfTriangle));
  }

  void readPrimitive(const Placed& placed, const std::vector<Affine>& frames) {
    const Json& primitive = *placed.primitive;
    const double mode = m_data.number(primitive, "mode", 4);
    const std::size_t first = m_mesh.points.size();
    appendPoints(placed, frames);
    const std::size_t accessor = m_data.index(primitive, "indices");
    std::vector<std::uint32_t> corners(m_mesh.points.size() - first);
    std::iota(corners.begin(), corners.end(), 0U);
    if (accessor != GltfData::none) corners = m_data.indices(accessor);
    for (const std::uint32_t corner : corners)
      if (corner >= m_mesh.points.size() - first)
        m_data.fail(named("accessors", accessor), "names point " + std::to_string(corner) + " of " +
                                                      std::to_string(m_mesh.points.size() - first));
    const std::size_t material = m_data.index(primitive, "material") + 1;  // none + 1 = 0
    if (material >= m_mesh.materials.size())
      m_data.fail("a primitive", "names a material that is not there");
    appendTriangles(corners, int(std::min(mode, 6.0)), std::uint32_t(first));
    m_mesh.materialOf.resize(m_mesh.triangles.size(), std::uint32_t(material));
  }

  /// Returns an attribute with one row per point; no values if it is missing.
  [[nodiscard]] Numbers attribute(const Json& attributes, const char* name, std::size_t least,
                                  std::size_t rows) const {
    const std::size_t accessor = m_data.index(attributes, name);
    if (accessor == GltfData::none) return {};
    Numbers numbers = m_data.numbers(accessor);
    constexpr std::size_t most = 4;
    if (numbers.components < least || numbers.components > most ||
        (rows != 0 && numbers.rows() != rows))
      m_data.fail(named("accessors", accessor), std::string("does not fit the points as ") + name);
    return numbers;
  }

  void appendPoints(const Placed& placed, const std::vector<Affine>& frames) {
    const Json& attributes = (*placed.primitive)["attributes"];
    Part part;
    part.node = placed.node;
    part.points = attribute(attributes, "POSITION", 3, 0);
    const std::size_t count = part.points.rows();
    part.normals = attribute(attributes, "NORMAL", 3, count);
    if (placed.skin != GltfData::none) {
      part.skin = placed.skin;
      part.binding = readBinding(m_data, attributes, count, m_parts.skins[placed.skin]);
    }
    const Numbers colours = attribute(attributes, "COLOR_0", 3, count);
    const Numbers uv = attribute(attributes, "TEXCOORD_0", 2, count);
    const auto row = [](const Numbers& n, std::size_t k) { return &n.values[k * n.components]; };
    const std::size_t first = m_mesh.points.size();
    place(part, m_parts.skins, frames, m_mesh);
    if (!colours.values.empty()) m_mesh.colours.resize(first, Linear{1, 1, 1});
    if (!uv.values.empty()) m_mesh.uv.resize(first);
    for (std::size_t k = 0; k < count; ++k) {
      if (!colours.values.empty()) {
        const float* c = row(colours, k);
        m_mesh.colours.push_back({c[0], c[1], c[2]});
      }
      if (!uv.values.empty()) m_mesh.uv.push_back({row(uv, k)[0], row(uv, k)[1]});
    }
    m_mesh.fillAttributes();
    if (m_animation) m_parts.parts.push_back(std::move(part));
  }

  /// Appends triangles of glTF's modes: 4 triangles, 5 a strip, 6 a fan.
  void appendTriangles(const std::vector<std::uint32_t>& corners, int mode, std::uint32_t first) {
    const std::size_t step = mode == 4 ? 3 : 1;
    for (std::size_t k = 0; k + 2 < corners.size(); k += step)
      m_mesh.triangles.push_back(
          {first + corners[mode == 6 ? 0 : k], first + corners[k + 1], first + corners[k + 2]});
  }

  void addNotes() {
    const std::size_t animations = m_data.listAt("animations").size();
    if (!m_animation && animations > 0)
      m_mesh.notes.push_back((animations == 1
                                  ? "Its animation stays"
                                  : "Its " + std::to_string(animations) + " animations stay") +
                             " at rest; mesh.animation is a name or a number of one.");
    if (m_animation && animations > 1)
      m_mesh.notes.push_back("Of its " + std::to_string(animations) +
                             " animations one is shown; mesh.animation chooses it.");
    if (m_animation && m_animation->movesOthers())
      m_mesh.notes.emplace_back(
          "Its animation also moves what is not shown, such as morph targets.");
    if (m_hasTargets) m_mesh.notes.emplace_back("Its morph targets are not applied.");
    if (m_hasLines) m_mesh.notes.emplace_back("Its points and lines are not shown.");
    if (const std::size_t scenes = m_data.listAt("scenes").size(); scenes > 1)
      m_mesh.notes.push_back("Of its " + std::to_string(scenes) + " scenes one is shown.");
    std::vector<std::string> unknown;
    for (const Json& name : m_data.listAt("extensionsUsed")) {
      if (!name.is_string()) m_data.fail("extensionsUsed", "must be a list of names");
      const auto& text = name.get_ref<const std::string&>();
      if (std::ranges::find(knownExtensions, text) == knownExtensions.end())
        unknown.push_back(text);
    }
    if (!unknown.empty()) m_mesh.notes.push_back(leftOut("extensions", unknown));
  }

  static constexpr std::array<std::pair<const char*, double>, 3> attributeBytes{
      {{"NORMAL", sizeof(Mesh::normals[0])},
       {"COLOR_0", sizeof(Linear)},
       {"TEXCOORD_0", sizeof(Mesh::uv[0])}}};

  /// An animation needs a point a second time, while the last posture is there.
  static constexpr double sceneBytesOfMotion =
      sizeof(Vec3) + sizeof(Mesh::normals[0]) + sceneBytesOfPoint;

  Reading& m_reading;
  GltfData m_data;
  GltfNodes m_nodes;
  std::optional<GltfAnimation> m_animation;
  MaterialReader m_materials;
  Mesh m_mesh;
  std::vector<Light> m_lights;
  Parts m_parts;
  std::vector<Placed> m_primitives;
  bool m_hasTargets = false;
  bool m_hasLines = false;
};

}  // namespace

Mesh readGltf(Reading& reading, const std::string& animation) {
  return GltfReader(reading, animation).read();
}

}  // namespace hogelscope::mesh
