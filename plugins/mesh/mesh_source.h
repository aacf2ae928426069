// SPDX-License-Identifier: BSD-3-Clause
// Meshes as content of a display: the plugin's ContentSource.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hogelscope/plugin.h"
#include "shaded_mesh.h"

namespace hogelscope::mesh {

struct MeshParams {
  std::string file;
  std::string animation;  ///< its name or number; "": at rest
  Vec3 position;
  Vec3 orientation;  ///< degrees
  double scale = 1;
  Shading shading = Shading::lambert;
  std::array<double, 3> background{};
};

void describe(ParameterVisitor& v, MeshParams& p);

class MeshSource : public plugin::ContentSource {
 public:
  void describe(ParameterVisitor& v) override;
  /// Reads the file if it is another one or has changed, and builds the scene if the pose has
  /// changed. If it throws, the source keeps showing its previous content.
  void open(const plugin::Panel& panel, const plugin::Place& place,
            const plugin::Progress& progress) override;
  [[nodiscard]] double duration() const override {
    return m_mesh->motion ? m_mesh->motion->duration() : 0;
  }
  /// Builds the scene at another time. If it throws, the source keeps its time.
  void setTime(double seconds) override;
  [[nodiscard]] std::vector<std::string> files() const override { return m_mesh->files; }
  [[nodiscard]] std::vector<std::string> notes() const override { return m_mesh->notes; }
  void depths(double& back, double& front) const override;
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override {
    m_shown->trace(rays, colours);
  }
  [[nodiscard]] bool traceDepths(std::span<const plugin::Ray> rays,
                                 std::span<double> depths) const override {
    m_shown->traceDepths(rays, depths);
    return true;
  }
  [[nodiscard]] plugin::Triangles triangles() const override { return m_shown->triangles(); }

 private:
  using Version = std::pair<std::filesystem::file_time_type, std::uintmax_t>;

  void read(const std::string& file, const plugin::Place& place, const plugin::Progress& progress);
  [[nodiscard]] static std::vector<Version> versionsOf(const std::vector<std::string>& files);
  void setLook();

  MeshParams m_params;
  std::shared_ptr<const Mesh> m_mesh;
  std::vector<Version> m_versions;  ///< of m_mesh's files at the time of reading
  std::string m_animation;          ///< of m_mesh
  plugin::Panel m_panel{};
  int m_threads = 1;
  Pose m_pose;        ///< of m_shown
  double m_time = 0;  ///< of m_shown, seconds
  std::unique_ptr<ShadedMesh> m_shown;
};

}  // namespace hogelscope::mesh
