// SPDX-License-Identifier: BSD-3-Clause
// The result of a reader: triangles with materials, and lights, in the file's frame and units.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "srgb.h"
#include "texture.h"

namespace hogelscope::mesh {

using Corners = std::array<std::uint32_t, 3>;

/// 4 × 3 numbers: a point's position is linear·p + origin.
struct Affine {
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 origin;

  [[nodiscard]] Vec3 direction(const Vec3& d) const {
    return d.x * axes[0] + d.y * axes[1] + d.z * axes[2];
  }
  [[nodiscard]] Vec3 point(const Vec3& p) const { return origin + direction(p); }
  /// Transforms a surface's normal; its length depends on the scale.
  [[nodiscard]] Vec3 normal(const Vec3& n) const;
  [[nodiscard]] Affine operator*(const Affine& b) const;
};

/// A texture of a surface; uv' = axes[0]·u + axes[1]·v + origin of the points' coordinates.
struct Layer {
  int texture = -1;  ///< -1: none
  Wrap wrap[2]{Wrap::repeat, Wrap::repeat};
  std::array<Vec2, 2> axes{Vec2{1, 0}, Vec2{0, 1}};
  Vec2 origin;

  [[nodiscard]] Vec2 place(const std::array<float, 2>& uv) const {
    return {axes[0].x * uv[0] + axes[1].x * uv[1] + origin.x,
            axes[0].y * uv[0] + axes[1].y * uv[1] + origin.y};
  }
  /// Returns the factor for areas of the points' coordinates.
  [[nodiscard]] double area() const { return axes[0].x * axes[1].y - axes[0].y * axes[1].x; }
};

/// The properties of a surface; `glow` is the texture of the emitted light.
struct Material {
  Linear colour{1, 1, 1};
  Layer layer;
  Linear emission{};
  Layer glow;
  bool isUnlit = false;
};

/// A light as in glTF's KHR_lights_punctual.
struct Light {
  enum class Kind : std::uint8_t { directional, point, spot };
  Kind kind = Kind::directional;
  Linear intensity{};  ///< candela, or lux for directional light
  Vec3 position;
  Vec3 direction{0, 0, -1};  ///< of the light, away from the source; length 1
  double range = 0;          ///< range of a point's or spot's light; 0: unlimited
  double cosInner = 1;       ///< a spot has full light inside this angle
  double cosOuter = 0;       ///< and none outside this one
};

/// The parts of a mesh that may move. There are no normals if no part of the file has them; a zero
/// normal means none.
struct Posture {
  std::vector<Vec3> points;
  std::vector<std::array<float, 3>> normals;
  std::vector<Light> lights;
};

/// The animation of a mesh.
class Motion {
 public:
  virtual ~Motion() = default;
  /// Returns how many seconds it lasts.
  [[nodiscard]] virtual double duration() const = 0;
  /// Returns the parts that move at a time.
  [[nodiscard]] virtual Posture at(double seconds) const = 0;
};

/// A mesh with its materials and lights, at the time 0 of its animation. Point attributes are empty
/// if no part of the file has them.
struct Mesh : Posture {
  std::vector<Linear> colours;
  std::vector<std::array<float, 2>> uv;  ///< v points down from the image's top
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> materialOf;  ///< of each triangle
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::shared_ptr<const Motion> motion;  ///< null: it stays at rest
  std::vector<std::string> files;        ///< all files read; the first is the mesh's own
  std::vector<std::string> notes;        ///< sentences on parts of the files that are not shown

  /// Adds missing attributes of the newest points, or of earlier ones.
  void fillAttributes();
};

/// The largest number of triangles in a file.
constexpr std::size_t mostTriangles = std::size_t{1} << 25U;

}  // namespace hogelscope::mesh
