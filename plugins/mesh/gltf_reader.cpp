// SPDX-License-Identifier: BSD-3-Clause
// glTF 2.0: the scene's nodes with their meshes and lights. Animations, skins and morph targets
// stay at rest, with a note.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "errors.h"
#include "gltf_data.h"
#include "gltf_materials.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

/// Returns a quaternion's rotation; its length must not be 0.
std::array<Vec3, 3> rotation(double x, double y, double z, double w) {
  const double n = x * x + y * y + z * z + w * w;
  const double s = n > 0 ? 2 / n : 0;
  return {Vec3{1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w)},
          Vec3{s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w)},
          Vec3{s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y)}};
}

/// A primitive of a node, and the node's frame.
struct Placed {
  const Json* primitive = nullptr;
  Affine frame;
};

/// The sizes of a primitive or of all of them.
struct Sizes {
  double points = 0;
  double triangles = 0;
  double numbers = 0;  ///< bytes used while they are read
};

class GltfReader {
 public:
  explicit GltfReader(Reading& reading)
      : m_reading(reading), m_data(reading), m_materials(m_data) {}

  Mesh read() {
    m_mesh.materials = m_materials.read();
    m_lights = readLights(m_data);
    walk(rootNodes());
    measure();
    for (std::size_t k = 0; k < m_primitives.size(); ++k) {
      m_reading.report(k, m_primitives.size());
      readPrimitive(*m_primitives[k].primitive, m_primitives[k].frame);
    }
    m_mesh.fillAttributes();
    m_mesh.files = m_data.files();
    m_materials.finish(m_mesh);
    addNotes();
    return std::move(m_mesh);
  }

 private:
  using Places = std::vector<std::pair<std::size_t, Affine>>;  // nodes with their parents' frames

  [[nodiscard]] std::vector<std::size_t> indexList(const Json& object, const char* member) const {
    std::vector<std::size_t> list;
    const auto found = object.find(member);
    if (found == object.end()) return list;
    if (!found->is_array()) m_data.fail(member, "must be a list of indices");
    for (const Json& index : *found) {
      if (!index.is_number_unsigned()) m_data.fail(member, "must be a list of indices");
      list.push_back(index.get<std::size_t>());
    }
    return list;
  }

  /// Returns the scene's nodes; without scenes, all nodes that are not children.
  [[nodiscard]] std::vector<std::size_t> rootNodes() const {
    const Json& root = m_data.root();
    if (root.contains("scenes")) {
      const std::size_t scene = m_data.index(root, "scene");
      return indexList(m_data.entry("scenes", scene == GltfData::none ? 0 : scene), "nodes");
    }
    const std::size_t count = m_data.listAt("nodes").size();
    std::vector<bool> isChild(count);
    for (std::size_t k = 0; k < count; ++k)
      for (const std::size_t child : indexList(m_data.entry("nodes", k), "children"))
        if (child < count) isChild[child] = true;
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < count; ++k)
      if (!isChild[k]) nodes.push_back(k);
    return nodes;
  }

  /// Visits a node, then its children, in the file's order.
  void walk(const std::vector<std::size_t>& roots) {
    Places open;
    const auto push = [&](const std::vector<std::size_t>& nodes, const Affine& parent) {
      for (auto k = nodes.rbegin(); k != nodes.rend(); ++k) open.emplace_back(*k, parent);
    };
    push(roots, {});
    std::vector<bool> isVisited(m_data.listAt("nodes").size());
    while (!open.empty()) {
      m_reading.poll();
      const auto [index, parent] = open.back();
      open.pop_back();
      const Json& node = m_data.entry("nodes", index);
      if (isVisited[index]) m_data.fail(named("nodes", index), "stands in the tree twice");
      isVisited[index] = true;
      const Affine frame = parent * transformOf(node);
      push(indexList(node, "children"), frame);
      readNode(node, frame);
    }
  }

  [[nodiscard]] Affine transformOf(const Json& node) const {
    const std::vector<double> m = m_data.list(node, "matrix", 16);
    if (!m.empty())
      return {{Vec3{m[0], m[1], m[2]}, Vec3{m[4], m[5], m[6]}, Vec3{m[8], m[9], m[10]}},
              {m[12], m[13], m[14]}};
    Affine local;
    const std::vector<double> r = m_data.list(node, "rotation", 4);
    const std::vector<double> s = m_data.list(node, "scale", 3);
    const std::vector<double> t = m_data.list(node, "translation", 3);
    if (!r.empty()) local.axes = rotation(r[0], r[1], r[2], r[3]);
    for (std::size_t k = 0; k < 3 && !s.empty(); ++k) local.axes[k] = s[k] * local.axes[k];
    if (!t.empty()) local.origin = {t[0], t[1], t[2]};
    return local;
  }

  void readNode(const Json& node, const Affine& frame) {
    const std::size_t mesh = m_data.index(node, "mesh");
    if (mesh != GltfData::none) {
      const Json& object = m_data.entry("meshes", mesh);
      const auto primitives = object.find("primitives");
      if (primitives == object.end() || !primitives->is_array())
        m_data.fail(named("meshes", mesh), "has no list of primitives");
      for (const Json& primitive : *primitives) placePrimitive(primitive, frame);
    }
    const auto extensions = node.find("extensions");
    if (extensions == node.end() || !extensions->is_object()) return;
    const auto lamp = extensions->find("KHR_lights_punctual");
    if (lamp != extensions->end() && lamp->is_object()) placeLight(*lamp, frame);
  }

  void placeLight(const Json& lamp, const Affine& frame) {
    const std::size_t index = m_data.index(lamp, "light");
    if (index >= m_lights.size()) m_data.fail("a node's light", "is not in the list of lights");
    Light light = m_lights[index];
    light.position = frame.origin;
    light.direction = normalise(frame.direction({0, 0, -1}));
    m_mesh.lights.push_back(light);
  }

  void placePrimitive(const Json& primitive, const Affine& frame) {
    if (!primitive.is_object() || !primitive.contains("attributes") ||
        !primitive["attributes"].is_object())
      m_data.fail("a primitive", "has no attributes");
    m_hasTargets = m_hasTargets || primitive.contains("targets");
    if (m_data.number(primitive, "mode", 4) < 4) {
      m_hasLines = true;
      return;
    }
    m_reading.take(2 * sizeof(Placed));
    m_primitives.push_back({&primitive, frame});
  }

  [[nodiscard]] Sizes sizesOf(const Json& primitive) const {
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
    sizes.numbers = std::max(sizes.numbers, 2 * corners * sizeof(std::uint32_t));
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
      const Sizes sizes = sizesOf(*m_primitives[k].primitive);
      whole = {whole.points + sizes.points, whole.triangles + sizes.triangles,
               std::max(whole.numbers, sizes.numbers)};
    }
    if (whole.points > 3.0 * mostTriangles || whole.triangles > double(mostTriangles))
      m_data.fail("the scene", "stands for more than 33554432 triangles");
    constexpr double bytesOfTriangle =
        sizeof(Corners) + sizeof(std::uint32_t) + sceneBytesOfTriangle;
    m_reading.take(whole.numbers + whole.points * bytesOfPoint() +
                   whole.triangles * bytesOfTriangle);
  }

  void readPrimitive(const Json& primitive, const Affine& frame) {
    const double mode = m_data.number(primitive, "mode", 4);
    const std::size_t first = m_mesh.points.size();
    appendPoints(primitive["attributes"], frame);
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
    if (numbers.components < least || (rows != 0 && numbers.rows() != rows))
      m_data.fail(named("accessors", accessor), std::string("does not fit the points as ") + name);
    return numbers;
  }

  void appendPoints(const Json& attributes, const Affine& frame) {
    const Numbers points = attribute(attributes, "POSITION", 3, 0);
    const std::size_t first = m_mesh.points.size();
    const auto row = [](const Numbers& n, std::size_t k) { return &n.values[k * n.components]; };
    for (std::size_t k = 0; k < points.rows(); ++k) {
      const float* p = row(points, k);
      m_mesh.points.push_back(frame.point({p[0], p[1], p[2]}));
    }
    const Numbers normals = attribute(attributes, "NORMAL", 3, points.rows());
    const Numbers colours = attribute(attributes, "COLOR_0", 3, points.rows());
    const Numbers uv = attribute(attributes, "TEXCOORD_0", 2, points.rows());
    if (!normals.values.empty()) m_mesh.normals.resize(first);
    if (!colours.values.empty()) m_mesh.colours.resize(first, Linear{1, 1, 1});
    if (!uv.values.empty()) m_mesh.uv.resize(first);
    for (std::size_t k = 0; k < points.rows(); ++k) {
      if (!normals.values.empty()) {
        const float* n = row(normals, k);
        const Vec3 turned = normalise(frame.normal({n[0], n[1], n[2]}));
        m_mesh.normals.push_back({float(turned.x), float(turned.y), float(turned.z)});
      }
      if (!colours.values.empty()) {
        const float* c = row(colours, k);
        m_mesh.colours.push_back({c[0], c[1], c[2]});
      }
      if (!uv.values.empty()) m_mesh.uv.push_back({row(uv, k)[0], row(uv, k)[1]});
    }
    m_mesh.fillAttributes();
  }

  /// Appends triangles of glTF's modes: 4 triangles, 5 a strip, 6 a fan.
  void appendTriangles(const std::vector<std::uint32_t>& corners, int mode, std::uint32_t first) {
    const std::size_t step = mode == 4 ? 3 : 1;
    for (std::size_t k = 0; k + 2 < corners.size(); k += step)
      m_mesh.triangles.push_back(
          {first + corners[mode == 6 ? 0 : k], first + corners[k + 1], first + corners[k + 2]});
  }

  void addNotes() {
    const auto note = [&](const char* list, const std::string& one) {
      const std::size_t count = m_data.listAt(list).size();
      if (count == 1) m_mesh.notes.push_back("Its " + one + " stays at rest.");
      if (count > 1)
        m_mesh.notes.push_back("Its " + std::to_string(count) + " " + one + "s stay at rest.");
    };
    note("animations", "animation");
    note("skins", "skin");
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

  Reading& m_reading;
  GltfData m_data;
  MaterialReader m_materials;
  Mesh m_mesh;
  std::vector<Light> m_lights;
  std::vector<Placed> m_primitives;
  bool m_hasTargets = false;
  bool m_hasLines = false;
};

}  // namespace

Mesh readGltf(Reading& reading) {
  return GltfReader(reading).read();
}

}  // namespace hogelscope::mesh
