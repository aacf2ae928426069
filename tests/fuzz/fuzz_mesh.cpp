// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes meshes of all kinds; the first letter says which: .glb, .gltf, .obj, .ply, or the .mtl of
// an .obj.
#include <array>
#include <stdexcept>

#include "mesh_reader.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

struct Going : plugin::Progress {
  [[nodiscard]] bool go(double) const override { return true; }
};

std::filesystem::path meshOf(char kind, std::string_view content) {
  switch (kind) {
    case 'b':
      return fileOf("a.glb", content);
    case 'g':
      return fileOf("a.gltf", content);
    case 'o':
      return fileOf("a.obj", content);
    case 'p':
      return fileOf("a.ply", content);
    case 'm':
      fileOf("a.mtl", content);
      return fileOf("b.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    default:
      return {};
  }
}

/// What all that shows a mesh relies on.
void checkMesh(const mesh::Mesh& mesh) {
  const std::size_t count = mesh.points.size();
  require(!mesh.triangles.empty() && mesh.materialOf.size() == mesh.triangles.size());
  for (const mesh::Corners& corners : mesh.triangles)
    for (const std::uint32_t corner : corners) require(corner < count);
  for (const std::uint32_t material : mesh.materialOf) require(material < mesh.materials.size());
  require(mesh.normals.empty() || mesh.normals.size() == count);
  require(mesh.colours.empty() || mesh.colours.size() == count);
  require(mesh.uv.empty() || mesh.uv.size() == count);
  for (const mesh::Material& material : mesh.materials)
    for (const mesh::Layer* layer : {&material.layer, &material.glow}) {
      require(layer->texture < int(mesh.textures.size()));
      if (layer->texture < 0) continue;
      const mesh::Texture& texture = mesh.textures[std::size_t(layer->texture)];
      for (const float u : {-0.3F, 0.4F, 1e9F}) {
        const Vec2 at = layer->place({u, 1 - u});
        (void)texture.sample(at.x, at.y, 1.5, layer->wrap);
      }
    }
}

}  // namespace

void fuzz(std::string_view input) {
  // One orange pixel, for materials that name it.
  [[maybe_unused]] static const std::filesystem::path picture = fileOf(
      "a.png",
      std::string_view("\211PNG\015\012\032\012\000\000\000\015IHDR\000\000\000\001\000\000\000"
                       "\001\010\002\000\000\000\220wS\336\000\000\000\014IDATx\234c\370\337"
                       " \000\000\004\021\001\220\307\033\015^\000\000\000\000IEND\256B`\202",
                       69));
  const std::filesystem::path file = input.empty() ? "" : meshOf(input[0], input.substr(1));
  if (file.empty()) return;
  constexpr std::uint64_t memory = 50000000;
  try {
    checkMesh(mesh::readMesh(file, memory, Going{}));
    const mesh::Mesh moving = mesh::readMesh(file, memory, Going{}, "0");  // refused without one
    checkMesh(moving);
    const double end = moving.motion->duration();
    for (const double time : {0.0, end / 3, end, end + 1}) {
      const mesh::Posture posture = moving.motion->at(time);
      require(posture.points.size() == moving.points.size());
      require(posture.normals.size() == moving.normals.size());
      require(posture.lights.size() == moving.lights.size());
    }
  } catch (const std::runtime_error& error) {
    mayRefuse([&] { throw InputError("", error.what()); });
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}
