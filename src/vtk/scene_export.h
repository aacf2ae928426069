// SPDX-License-Identifier: BSD-3-Clause
// Export of the 3-D scene for other programs, as glTF or VTP. It is made of the sources, not of
// what is drawn, so it depends on no switch of the scene.
#pragma once

#include <filesystem>
#include <vector>

#include "core/optics/session.h"
#include "scene_data.h"

namespace hogelscope
{

/// The exported objects, in the world; the file has metres.
struct SceneParts
{
  PanelParams display; ///< resolved
  std::vector<CameraState> states;
  VtkMesh mesh;        ///< in the display frame; null: none
  VtkImage panelImage; ///< RGB over the whole panel; null: none. VTP has no images
};

/// Writes panel, hogel grid, frusta and mesh. `.gltf`: an object each, the panel with its image,
/// and a camera for each state, all in one file. `.vtp`: one polydata with the cell arrays Part (0
/// panel, 1 hogel grid, 2 frusta, 3 mesh) and State (the camera state's index, else -1) and the
/// point array Colour. May run on any thread. Throws InputError for another extension or if the
/// file cannot be written.
void exportScene(const std::filesystem::path& file, const SceneParts& parts);

} // namespace hogelscope
