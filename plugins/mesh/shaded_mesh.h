// SPDX-License-Identifier: BSD-3-Clause
// A mesh in the display frame with its lights, and the colours that rays meet.
#pragma once

#include <memory>
#include <optional>

#include "embree_scene.h"
#include "hogelscope/plugin.h"
#include "mesh.h"

namespace hogelscope::mesh {

enum class Shading : std::uint8_t { unlit, lambert };

/// The pose of a mesh: displayFromFile is a rotation, a uniform scale and a translation.
struct Pose {
  Vec3 position;
  Vec3 orientation;  ///< degrees
  double scale = 1;
  bool operator==(const Pose&) const = default;
};

class ShadedMesh {
 public:
  /// Shows the mesh in a posture, its own or one of its motion. Keeps triangles with the same three
  /// points once. Throws if the pose moves a point farther than 10⁶ m.
  ShadedMesh(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Posture> posture,
             const Pose& pose, int threads, const plugin::Progress& progress);

  /// Sets the shading of surfaces. The panel determines how much of a texture a ray covers.
  void setLook(Shading shading, const plugin::Panel& panel, const plugin::Colour& background);

  /// Implements ContentSource::trace().
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const;
  /// Implements ContentSource::traceDepths().
  void traceDepths(std::span<const plugin::Ray> rays, std::span<double> depths) const;
  [[nodiscard]] plugin::Triangles triangles() const;
  [[nodiscard]] const std::shared_ptr<const Mesh>& mesh() const { return m_mesh; }
  [[nodiscard]] double back() const { return m_back; }
  [[nodiscard]] double front() const { return m_front; }

 private:
  void placeLights(const Affine& displayFromFile);
  [[nodiscard]] plugin::Colour colour(const Hit& hit, std::uint32_t number,
                                      const plugin::Ray& ray) const;
  [[nodiscard]] Linear albedo(const Hit& hit, const Material& material) const;
  [[nodiscard]] Linear emission(const Hit& hit, const Material& material) const;
  [[nodiscard]] Linear textureColour(const Hit& hit, const Layer& layer) const;
  [[nodiscard]] Linear lightOn(const Hit& hit, const plugin::Ray& ray) const;
  [[nodiscard]] Vec3 shadingNormal(const Hit& hit, const Vec3& geometric) const;

  std::shared_ptr<const Mesh> m_mesh;
  std::shared_ptr<const Posture> m_posture;
  std::vector<std::uint32_t> m_materialOf;  ///< of the remaining triangles
  std::unique_ptr<EmbreeScene> m_scene;
  Affine m_displayFromFile;
  double m_unit = 1;  ///< the file's unit in metres
  double m_back = 0;
  double m_front = 0;
  std::vector<Light> m_lights;  ///< in the display frame
  float m_ambient = 0;
  Shading m_shading = Shading::unlit;
  plugin::Colour m_background;
  double m_pitch = 0;
  double m_slopeStep = 0;
  /// The colour of each material that has a single colour.
  std::vector<std::optional<plugin::Colour>> m_plain;
};

}  // namespace hogelscope::mesh
