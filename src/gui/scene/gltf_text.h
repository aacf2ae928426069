// SPDX-License-Identifier: BSD-3-Clause
// Conversion of geometry and cameras to glTF.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"
#include "gui/scene/mesh_actors.h"

class vtkImageData;

namespace hogelscope {

/// Returns a complete glTF document. `parts` are panel, hogel grid, frusta and optionally a mesh,
/// in the world, with colours as point scalars. `panelImage`, unless null, replaces the panel's
/// colour. Returns "" if VTK's export fails.
std::string gltfText(const std::vector<VtkMesh>& parts, const std::vector<CameraState>& states,
                     vtkImageData* panelImage);

}  // namespace hogelscope
