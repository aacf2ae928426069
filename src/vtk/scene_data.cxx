// SPDX-License-Identifier: BSD-3-Clause
#include "scene_data.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace hogelscope
{

namespace
{

/// The largest number of triangles that software rendering can rotate smoothly.
constexpr std::size_t mostTriangles = 500000;

VtkMesh boxAround(vtkPolyData* mesh)
{
  const vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(mesh->GetBounds());
  outline->Update();
  return outline->GetOutput();
}

} // namespace

VtkImage toVtkImage(const Image& image, const std::array<std::uint8_t, 3>& unseen)
{
  auto result = VtkImage::New();
  result->SetDimensions(image.width, image.height, 1);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<std::uint8_t*>(result->GetScalarPointer());
  for (int y = image.height - 1; y >= 0; --y)
  {
    for (int x = 0; x < image.width; ++x, to += 3)
    {
      const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
      std::copy_n(image.seen[at] != 0 ? &image.rgb[3 * at] : unseen.data(), 3, to);
    }
  }
  return result;
}

VtkImage toVtkImage(vtkImageData& view, const std::array<std::uint8_t, 3>& unseen)
{
  auto result = VtkImage::New();
  result->SetDimensions(view.GetDimensions());
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* rgb = static_cast<const std::uint8_t*>(view.GetScalarPointer());
  const auto* seen =
    static_cast<const std::uint8_t*>(view.GetPointData()->GetArray("Seen")->GetVoidPointer(0));
  auto* to = static_cast<std::uint8_t*>(result->GetScalarPointer());
  for (vtkIdType k = 0; k < view.GetNumberOfPoints(); ++k, rgb += 3, to += 3)
  {
    std::copy_n(seen[k] != 0 ? rgb : unseen.data(), 3, to);
  }
  return result;
}

VtkMesh toVtkMesh(const plugin::Triangles& triangles)
{
  const auto& [points, corners, colours] = triangles;
  if (corners.empty())
  {
    return nullptr;
  }
  auto mesh = VtkMesh::New();
  const vtkNew<vtkPoints> places;
  const std::size_t count = points.size() / 3;
  for (std::size_t k = 0; k < count; ++k)
  {
    places->InsertNextPoint(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
  }
  mesh->SetPoints(places);
  if (corners.size() / 3 > mostTriangles)
  {
    return boxAround(mesh);
  }
  const vtkNew<vtkCellArray> cells;
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
  {
    cells->InsertNextCell({ corners[k], corners[k + 1], corners[k + 2] });
  }
  mesh->SetPolys(cells);
  if (colours.size() == points.size())
  {
    const vtkNew<vtkUnsignedCharArray> rgb;
    rgb->SetNumberOfComponents(3);
    for (std::size_t k = 0; k < count; ++k)
    {
      rgb->InsertNextTuple3(colours[3 * k], colours[3 * k + 1], colours[3 * k + 2]);
    }
    mesh->GetPointData()->SetScalars(rgb);
  }
  return mesh;
}

void setBody(vtkPolyData* data, const std::vector<std::vector<Vec3>>& sections, bool hasFaces)
{
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> faces;
  const vtkNew<vtkCellArray> edges;

  for (const std::vector<Vec3>& section : sections)
  {
    for (const Vec3& p : section)
    {
      points->InsertNextPoint(p.x, p.y, p.z);
    }
  }
  for (vtkIdType section = 0; section < vtkIdType(sections.size()); ++section)
  {
    const vtkIdType first = 4 * section;
    const bool isAtEnd = section == 0 || section + 1 == vtkIdType(sections.size());
    if (isAtEnd)
    {
      faces->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    }
    for (vtkIdType k = 0; k < 4; ++k)
    {
      const vtkIdType next = first + (k + 1) % 4;
      if (isAtEnd)
      {
        edges->InsertNextCell({ first + k, next });
      }
      if (section == 0)
      {
        continue;
      }
      faces->InsertNextCell({ first + k, next, next - 4, first + k - 4 });
      edges->InsertNextCell({ first + k, first + k - 4 });
    }
  }

  data->Initialize();
  data->SetPoints(points);
  data->SetLines(edges);
  if (hasFaces)
  {
    data->SetPolys(faces);
  }
  data->Modified();
}

} // namespace hogelscope
