// SPDX-License-Identifier: BSD-3-Clause
// Geometry and cameras as glTF.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"
#include "gui/scene/mesh_actors.h"

class vtkImageData;

namespace hogelscope {

/// Returns a document with everything in it. `parts` are panel, hogel grid, frusta and maybe a
/// mesh, in the world, with colours as their points' scalars; the panel has `panelImage` in place
/// of its colour unless that is null. "" where VTK cannot.
std::string gltfText(const std::vector<VtkMesh>& parts, const std::vector<CameraState>& states,
                     vtkImageData* panelImage);

}  // namespace hogelscope
