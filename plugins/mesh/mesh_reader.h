// SPDX-License-Identifier: BSD-3-Clause
// Reads meshes: glTF 2.0 (.gltf, .glb), Wavefront (.obj with .mtl), Stanford's PLY. VTK's readers
// of the three crash on damaged files, so these are our own.
#pragma once

#include <string>

#include "hogelscope/plugin.h"
#include "mesh.h"
#include "reading.h"

namespace hogelscope::mesh {

/// Reads a file by its ending. Throws, with one line that names the file, whatever cannot be shown
/// whole: missing parts, indices outside of lists, NaN, no faces, more than `memory` bytes for the
/// mesh, its textures and its scene; and "stopped" if the listener stops.
Mesh readMesh(const std::string& file, std::uint64_t memory, const plugin::Progress& progress);

Mesh readGltf(Reading& reading);
Mesh readObj(Reading& reading);
Mesh readPly(Reading& reading);

/// Returns the path of a file that another one names.
std::string besides(const std::string& file, const std::string& name);

}  // namespace hogelscope::mesh
