// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_nodes.h"

#include <algorithm>

namespace hogelscope::mesh {

namespace {

/// Returns a quaternion's rotation; that of zeros is none.
std::array<Vec3, 3> turned(const std::array<double, 4>& quaternion) {
  const auto [x, y, z, w] = quaternion;
  const double n = x * x + y * y + z * z + w * w;
  const double s = n > 0 ? 2 / n : 0;
  return {Vec3{1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w)},
          Vec3{s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w)},
          Vec3{s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y)}};
}

std::vector<std::size_t> indexList(const GltfData& data, const Json& object, const char* member) {
  std::vector<std::size_t> list;
  const auto found = object.find(member);
  if (found == object.end()) return list;
  if (!found->is_array()) data.fail(member, "must be a list of indices");
  for (const Json& index : *found) {
    if (!index.is_number_unsigned()) data.fail(member, "must be a list of indices");
    list.push_back(index.get<std::size_t>());
  }
  return list;
}

/// Returns the scene's nodes; without scenes, all nodes that are not children.
std::vector<std::size_t> rootNodes(const GltfData& data) {
  const Json& root = data.root();
  if (root.contains("scenes")) {
    const std::size_t scene = data.index(root, "scene");
    return indexList(data, data.entry("scenes", scene == GltfData::none ? 0 : scene), "nodes");
  }
  const std::size_t count = data.listAt("nodes").size();
  std::vector<bool> isChild(count);
  for (std::size_t k = 0; k < count; ++k)
    for (const std::size_t child : indexList(data, data.entry("nodes", k), "children"))
      if (child < count) isChild[child] = true;
  std::vector<std::size_t> nodes;
  for (std::size_t k = 0; k < count; ++k)
    if (!isChild[k]) nodes.push_back(k);
  return nodes;
}

NodePose poseOf(const GltfData& data, const Json& node) {
  NodePose pose;
  if (const std::vector<double> m = data.list(node, "matrix", 16); !m.empty())
    pose.matrix = affineOf(m.data());
  const auto read = [&](const char* member, auto& values) {
    const std::vector<double> list = data.list(node, member, values.size());
    std::ranges::copy(list, values.begin());
  };
  read("translation", pose.translation);
  read("rotation", pose.rotation);
  read("scale", pose.scale);
  return pose;
}

}  // namespace

Affine NodePose::frame() const {
  if (matrix) return *matrix;
  Affine frame{turned(rotation), {translation[0], translation[1], translation[2]}};
  for (std::size_t k = 0; k < 3; ++k) frame.axes[k] = scale[k] * frame.axes[k];
  return frame;
}

GltfNodes::GltfNodes(const GltfData& data) : m_places(data.listAt("nodes").size(), none) {
  std::vector<Node> open;
  const auto push = [&](const std::vector<std::size_t>& numbers, std::size_t parent) {
    for (auto k = numbers.rbegin(); k != numbers.rend(); ++k) open.push_back({*k, parent});
  };
  push(rootNodes(data), none);
  while (!open.empty()) {
    data.reading().poll();
    const Node node = open.back();
    open.pop_back();
    const Json& object = data.entry("nodes", node.number);
    if (m_places[node.number] != none)
      data.fail(named("nodes", node.number), "stands in the tree twice");
    data.reading().take(sizeof(Node) + sizeof(NodePose) + sizeof(Affine));
    m_places[node.number] = m_nodes.size();
    m_nodes.push_back(node);
    m_rest.push_back(poseOf(data, object));
    push(indexList(data, object, "children"), m_places[node.number]);
  }
}

std::size_t GltfNodes::placeOf(std::size_t number) const {
  return number < m_places.size() ? m_places[number] : none;
}

std::vector<Affine> GltfNodes::frames(const std::vector<NodePose>& poses) const {
  std::vector<Affine> frames;
  frames.reserve(poses.size());
  for (std::size_t place = 0; place < poses.size(); ++place) {
    const std::size_t parent = m_nodes[place].parent;
    frames.push_back((parent == none ? Affine{} : frames[parent]) * poses[place].frame());
  }
  return frames;
}

}  // namespace hogelscope::mesh
