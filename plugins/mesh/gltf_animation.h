// SPDX-License-Identifier: BSD-3-Clause
// An animation of a glTF file: the poses of its nodes over time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gltf_nodes.h"

namespace hogelscope::mesh {

class GltfAnimation {
 public:
  /// Reads an animation by its name, or its number from 0. Throws if there is none, with the names
  /// of those that there are.
  GltfAnimation(const GltfData& data, const GltfNodes& nodes, const std::string& nameOrNumber);

  /// Returns the time of the last key in seconds.
  [[nodiscard]] double duration() const { return m_duration; }
  /// Sets what it moves in poses of nodes, by place, to a time (glTF 2.0, appendix C). Before a
  /// channel's first key, and after its last one, the key's value is held.
  void apply(double seconds, std::vector<NodePose>& poses) const;
  /// Whether it also moves what is not shown: weights of morph targets, or an extension's
  /// properties.
  [[nodiscard]] bool movesOthers() const { return m_movesOthers; }

 private:
  enum class Path : std::uint8_t { translation, rotation, scale };
  enum class Interpolation : std::uint8_t { linear, step, cubicSpline };

  /// The values of a node's property at growing times; of a cubic spline each has a tangent before
  /// and one after it.
  struct Channel {
    std::size_t node = 0;  ///< its place
    Path path = Path::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;
    Numbers values;

    template <std::size_t N>
    [[nodiscard]] std::array<double, N> at(double seconds) const;
  };

  void readChannel(const GltfData& data, const GltfNodes& nodes, const Json& animation,
                   const Json& channel);

  std::vector<Channel> m_channels;
  double m_duration = 0;
  bool m_movesOthers = false;
};

}  // namespace hogelscope::mesh
