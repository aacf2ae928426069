// SPDX-License-Identifier: BSD-3-Clause
// Reads meshes: glTF 2.0 (.gltf, .glb), Wavefront (.obj with .mtl), Stanford's PLY. VTK's readers
// of these formats crash on damaged files, so these are independent.
#pragma once

#include <string>

#include "hogelscope/plugin.h"
#include "mesh.h"
#include "reading.h"

namespace hogelscope::mesh {

/// Reads a file by its extension, with one of its animations, by name or number, or ("") at rest.
/// Throws one line that names the file for anything that prevents a
/// complete mesh: missing parts, indices out of range, NaN, no faces, more than `memory` bytes for
/// the mesh, its textures and its scene; and "stopped" if the listener cancels.
Mesh readMesh(const std::string& file, std::uint64_t memory, const plugin::Progress& progress,
              const std::string& animation = {});

Mesh readGltf(Reading& reading, const std::string& animation);
Mesh readObj(Reading& reading);
Mesh readPly(Reading& reading);

/// Returns the path of a file that another file names.
std::string besides(const std::string& file, const std::string& name);

}  // namespace hogelscope::mesh
