// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

std::string endingOf(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return ending;
}

Mesh readByEnding(Reading& reading, const std::string& animation) {
  const std::string ending = endingOf(reading.file());
  if (ending == ".gltf" || ending == ".glb") return readGltf(reading, animation);
  if (!animation.empty())
    fail(reading.file(), "has no animation " + animation, "leave mesh.animation empty");
  if (ending == ".obj") return readObj(reading);
  if (ending == ".ply") return readPly(reading);
  fail(reading.file(), "is no known kind of mesh", "use .gltf, .glb, .obj or .ply");
}

bool isFinite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Throws if an entry of a list of point attributes is NaN or infinite.
template <class List>
void checkFinite(const List& list, const char* what, const std::string& file) {
  const auto wrong = std::find_if_not(list.begin(), list.end(), [](const auto& entry) {
    return std::all_of(entry.begin(), entry.end(), [](float x) { return std::isfinite(x); });
  });
  if (wrong != list.end())
    fail(file, what + (" of point " + std::to_string(wrong - list.begin())), "is NaN or infinite");
}

void check(const Mesh& mesh, const std::string& file) {
  if (mesh.triangles.empty())
    fail(file, "has no faces", "a surface of triangles is needed, not points or lines alone");
  const auto wrong = std::find_if_not(mesh.points.begin(), mesh.points.end(), isFinite);
  if (wrong != mesh.points.end())
    fail(file, "point " + std::to_string(wrong - mesh.points.begin()), "is NaN or infinite");
  checkFinite(mesh.normals, "the normal", file);
  checkFinite(mesh.colours, "the colour", file);
  checkFinite(mesh.uv, "the texture coordinate", file);
  for (const Corners& corners : mesh.triangles)
    for (const std::uint32_t corner : corners)
      if (corner >= mesh.points.size())
        fail(file, "a face names point " + std::to_string(corner),
             "there are " + std::to_string(mesh.points.size()) + ", counted from 0");
}

}  // namespace

std::string besides(const std::string& file, const std::string& name) {
  return std::filesystem::path(file).parent_path() / name;
}

Mesh readMesh(const std::string& file, std::uint64_t memory, const plugin::Progress& progress,
              const std::string& animation) {
  Reading reading(file, memory, progress);
  Mesh mesh = readByEnding(reading, animation);
  check(mesh, file);
  return mesh;
}

}  // namespace hogelscope::mesh
