// SPDX-License-Identifier: BSD-3-Clause
// The tree of a glTF scene's nodes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gltf_data.h"
#include "mesh.h"

namespace hogelscope::mesh {

/// Returns a matrix of 4×4 numbers, column by column, without its last row.
template <class Number>
Affine affineOf(const Number* m) {
  return {{Vec3{m[0], m[1], m[2]}, Vec3{m[4], m[5], m[6]}, Vec3{m[8], m[9], m[10]}},
          {m[12], m[13], m[14]}};
}

/// A node's frame in its parent's: a matrix, or a translation, a rotation and a scale.
struct NodePose {
  std::optional<Affine> matrix;
  std::array<double, 3> translation{};
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< a quaternion x, y, z, w of any length but 0
  std::array<double, 3> scale{1, 1, 1};

  [[nodiscard]] Affine frame() const;
};

/// The nodes of the scene that is shown; without scenes, all. A node comes before its children, and
/// they in the file's order.
class GltfNodes {
 public:
  static constexpr std::size_t none = GltfData::none;

  explicit GltfNodes(const GltfData& data);

  [[nodiscard]] std::size_t count() const { return m_nodes.size(); }
  /// Returns the number in the file of a node at a place.
  [[nodiscard]] std::size_t numberOf(std::size_t place) const { return m_nodes[place].number; }
  /// Returns the place of a node by its number in the file; `none` if the scene does not have it.
  [[nodiscard]] std::size_t placeOf(std::size_t number) const;
  /// Returns the nodes' poses in the file, by place.
  [[nodiscard]] const std::vector<NodePose>& rest() const { return m_rest; }
  /// Returns the nodes' frames in the file's frame for poses, by place.
  [[nodiscard]] std::vector<Affine> frames(const std::vector<NodePose>& poses) const;

 private:
  struct Node {
    std::size_t number;
    std::size_t parent;  ///< its place
  };

  std::vector<Node> m_nodes;
  std::vector<NodePose> m_rest;
  std::vector<std::size_t> m_places;  ///< by number
};

}  // namespace hogelscope::mesh
