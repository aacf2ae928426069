// SPDX-License-Identifier: BSD-3-Clause
// VTK's data of the 3-D scene: images, meshes and the body of the viewing zone.
#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/optics/image.h"
#include "core/panel/viewing_zone.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope
{

using VtkImage = vtkSmartPointer<vtkImageData>;
using VtkMesh = vtkSmartPointer<vtkPolyData>;

/// The colour of the panel where it emits no light to the eye.
inline constexpr std::array<std::uint8_t, 3> panelColour{ 61, 71, 92 };

/// Returns an RGB texture with row 0 at the bottom, as in VTK. Unseen pixels have the colour
/// `unseen`.
VtkImage toVtkImage(const Image& image, const std::array<std::uint8_t, 3>& unseen);
/// Returns the same for an output of vtkHogelViewFilter.
VtkImage toVtkImage(vtkImageData& view, const std::array<std::uint8_t, 3>& unseen);

/// Returns the triangles with a colour for each point, or their bounding box if there are more than
/// half a million; null if there are none.
VtkMesh toVtkMesh(const plugin::Triangles& triangles);

/// Sets the body between quadrangles, in the world, with its edges as lines and, if wanted, its
/// faces as quads.
void setBody(vtkPolyData* data, const std::vector<std::vector<Vec3>>& sections, bool hasFaces);

} // namespace hogelscope
