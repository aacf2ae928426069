// SPDX-License-Identifier: BSD-3-Clause
// Reads meshes: glTF 2.0 (.gltf, .glb), Wavefront (.obj with .mtl), Stanford's PLY. VTK's readers
// of the three crash on damaged files, so these are our own.
#pragma once

#include <string>

#include "hogelscope/plugin.h"
#include "mesh.h"

namespace hogelscope::mesh {

/// Reads a file by its ending. Throws, with one line that names the file, whatever cannot be shown
/// whole: missing parts, indices outside of lists, NaN, no faces; and "stopped" if the listener
/// stops.
Mesh readMesh(const std::string& file, const plugin::Progress& progress);

Mesh readGltf(const std::string& file);
Mesh readObj(const std::string& file, const plugin::Progress& progress);
Mesh readPly(const std::string& file, const plugin::Progress& progress);

/// Tells the listener how much of a file has been read. Throws "stopped" if it stops.
void report(const plugin::Progress& progress, std::size_t read, std::size_t bytes);

/// Returns the path of a file that another one names.
std::string besides(const std::string& file, const std::string& name);

}  // namespace hogelscope::mesh
