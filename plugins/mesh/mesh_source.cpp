// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_source.h"

#include <array>
#include <stdexcept>
#include <string_view>

#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

/// The listener of work that is not stopped.
class Unheard : public plugin::Progress {
 public:
  [[nodiscard]] bool go(double /*done*/) const override { return true; }
};

}  // namespace

void describe(ParameterVisitor& v, MeshParams& p) {
  static constexpr std::array<std::string_view, 2> shadings{"unlit", "lambert"};
  auto& [file, animation, position, orientation, scale, shading, background] = p;
  v.group("mesh", "A 3-D scene out of a mesh file (plugin mesh).");
  v.field("file", file, "The mesh: .glb, .gltf, .obj or .ply.");
  v.nameOrNumber(
      "animation", animation,
      "An animation of a glTF file, by its name or its number from 0, whose frames are shown; "
      "empty: at rest.");
  v.field("position", position, {-1000, 1000, 0.01}, "m",
          "Where the file's origin stands in the display frame.");
  v.field("orientation", orientation, {-360, 360, 1}, "°",
          "How the mesh is turned about the display's axes: first y, then x, then z.");
  v.field("scale", scale, {1e-6, 1e6, 0.01}, "", "How many metres the file's unit is long.");
  v.field("shading", shading, shadings,
          "unlit: colours as they are in the file; lambert: matt surfaces in the light of the "
          "file's lamps, else of a headlight, with hard shadows.");
  v.field("background", background, {0, 255, 1}, "",
          "What rays see that meet nothing: red, green, blue in code values.");
}

void MeshSource::describe(ParameterVisitor& v) {
  mesh::describe(v, m_params);
}

std::vector<MeshSource::Version> MeshSource::versionsOf(const std::vector<std::string>& files) {
  std::vector<Version> versions;
  for (const std::string& file : files) {
    std::error_code none;
    versions.emplace_back(std::filesystem::last_write_time(file, none),
                          std::filesystem::file_size(file, none));
  }
  return versions;
}

void MeshSource::read(const std::string& file, const plugin::Place& place,
                      const plugin::Progress& progress) {
  if (m_mesh && m_mesh->files[0] == file && m_animation == m_params.animation &&
      versionsOf(m_mesh->files) == m_versions)
    return;
  m_mesh = std::make_shared<const Mesh>(readMesh(file, place.memory, progress, m_params.animation));
  m_animation = m_params.animation;
  m_versions = versionsOf(m_mesh->files);
}

void MeshSource::open(const plugin::Panel& panel, const plugin::Place& place,
                      const plugin::Progress& progress) {
  if (m_params.file.empty())
    throw std::runtime_error("mesh.file: is empty: name a .glb, .gltf, .obj or .ply file");
  read(std::filesystem::path(place.folder) / m_params.file, place, progress);
  if (!progress.go(0.5)) throw std::runtime_error("stopped");
  const Pose pose{m_params.position, m_params.orientation, m_params.scale};
  if (!m_shown || m_shown->mesh() != m_mesh || pose != m_pose || m_time != 0) {
    m_shown = std::make_unique<ShadedMesh>(m_mesh, m_mesh, pose, place.threads, progress);
    m_pose = pose;
    m_time = 0;
  }
  m_panel = panel;
  m_threads = place.threads;
  setLook();
}

void MeshSource::setTime(double seconds) {
  if (!m_mesh->motion || seconds == m_time) return;
  auto posture = std::make_shared<const Posture>(m_mesh->motion->at(seconds));
  m_shown = std::make_unique<ShadedMesh>(m_mesh, std::move(posture), m_pose, m_threads, Unheard());
  m_time = seconds;
  setLook();
}

void MeshSource::setLook() {
  const auto& [r, g, b] = m_params.background;
  m_shown->setLook(m_params.shading, m_panel, {float(r), float(g), float(b)});
}

void MeshSource::depths(double& back, double& front) const {
  back = m_shown->back();
  front = m_shown->front();
}

}  // namespace hogelscope::mesh
