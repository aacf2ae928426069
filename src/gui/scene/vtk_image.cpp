// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/vtk_image.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>

namespace hogelscope {

vtkSmartPointer<vtkImageData> toVtkImage(const Image& image,
                                         const std::array<std::uint8_t, 3>& unseen) {
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(image.width, image.height, 1);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<std::uint8_t*>(result->GetScalarPointer());
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x, to += 3) {
      const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
      std::copy_n(image.seen[at] != 0 ? &image.rgb[3 * at] : unseen.data(), 3, to);
    }
  }
  return result;
}

vtkSmartPointer<vtkImageData> toVtkImage(vtkImageData& view,
                                         const std::array<std::uint8_t, 3>& unseen) {
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(view.GetDimensions());
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* rgb = static_cast<const std::uint8_t*>(view.GetScalarPointer());
  const auto* seen =
      static_cast<const std::uint8_t*>(view.GetPointData()->GetArray("Seen")->GetVoidPointer(0));
  auto* to = static_cast<std::uint8_t*>(result->GetScalarPointer());
  for (vtkIdType k = 0; k < view.GetNumberOfPoints(); ++k, rgb += 3, to += 3)
    std::copy_n(seen[k] != 0 ? rgb : unseen.data(), 3, to);
  return result;
}

}  // namespace hogelscope
