// SPDX-License-Identifier: BSD-3-Clause
// Images as textures of the 3-D scene.
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>

#include "core/optics/image.h"

namespace hogelscope {

/// RGB, row 0 at the bottom as VTK has it; what is not seen has the colour given.
vtkSmartPointer<vtkImageData> toVtkImage(const Image& image,
                                         const std::array<std::uint8_t, 3>& unseen);

/// The same of an output of vtkHogelViewFilter.
vtkSmartPointer<vtkImageData> toVtkImage(vtkImageData& view,
                                         const std::array<std::uint8_t, 3>& unseen);

}  // namespace hogelscope
