// SPDX-License-Identifier: BSD-3-Clause
// Conversion of images to textures of the 3-D scene.
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>

#include "core/optics/image.h"

namespace hogelscope {

/// Returns an RGB texture with row 0 at the bottom, as in VTK. Unseen pixels have the colour
/// `unseen`.
vtkSmartPointer<vtkImageData> toVtkImage(const Image& image,
                                         const std::array<std::uint8_t, 3>& unseen);

/// Returns the same for an output of vtkHogelViewFilter.
vtkSmartPointer<vtkImageData> toVtkImage(vtkImageData& view,
                                         const std::array<std::uint8_t, 3>& unseen);

}  // namespace hogelscope
