// SPDX-License-Identifier: BSD-3-Clause
// Reads meshes: glTF 2.0 (.gltf, .glb), Wavefront (.obj with .mtl), Stanford's PLY. VTK's readers
// of the three crash on damaged files, so these are our own.
#pragma once

#include <string>

#include "mesh.h"

namespace hogelscope::mesh {

/// Reads a file by its ending. Throws, with one line that names the file, whatever cannot be shown
/// whole: missing parts, indices outside of lists, NaN, no faces.
Mesh readMesh(const std::string& file);

Mesh readGltf(const std::string& file);
Mesh readObj(const std::string& file);
Mesh readPly(const std::string& file);

/// Returns the path of a file that another one names.
std::string besides(const std::string& file, const std::string& name);

}  // namespace hogelscope::mesh
