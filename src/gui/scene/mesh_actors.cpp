// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/mesh_actors.h"

#include <vtkCellArray.h>
#include <vtkCellPicker.h>
#include <vtkOutlineSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>

namespace hogelscope {

namespace {

/// The largest number of triangles that software rendering can rotate smoothly.
constexpr std::size_t mostTriangles = 500000;

VtkMesh boxAround(vtkPolyData* mesh) {
  const vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(mesh->GetBounds());
  outline->Update();
  return outline->GetOutput();
}

}  // namespace

VtkMesh toVtkMesh(const plugin::Triangles& triangles) {
  const auto& [points, corners, colours] = triangles;
  if (corners.empty()) return nullptr;
  auto mesh = VtkMesh::New();
  const vtkNew<vtkPoints> places;
  const std::size_t count = points.size() / 3;
  for (std::size_t k = 0; k < count; ++k)
    places->InsertNextPoint(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
  mesh->SetPoints(places);
  if (corners.size() / 3 > mostTriangles) return boxAround(mesh);
  const vtkNew<vtkCellArray> cells;
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
    cells->InsertNextCell({corners[k], corners[k + 1], corners[k + 2]});
  mesh->SetPolys(cells);
  if (colours.size() == points.size()) {
    const vtkNew<vtkUnsignedCharArray> rgb;
    rgb->SetNumberOfComponents(3);
    for (std::size_t k = 0; k < count; ++k)
      rgb->InsertNextTuple3(colours[3 * k], colours[3 * k + 1], colours[3 * k + 2]);
    mesh->GetPointData()->SetScalars(rgb);
  }
  return mesh;
}

MeshActors::MeshActors(vtkRenderer* renderer) {
  m_actor->SetMapper(m_mapper);
  m_actor->GetProperty()->SetAmbient(0.4);
  m_actor->GetProperty()->SetDiffuse(0.6);
  renderer->AddActor(m_actor);
  setMesh(nullptr);
}

void MeshActors::setMesh(const VtkMesh& mesh) {
  m_mapper->SetInputData(mesh);
  m_actor->SetVisibility(m_isVisible && mesh != nullptr);
}

void MeshActors::setDisplay(const DisplayParams& display) {
  if (std::exchange(m_display, display) == display) return;
  const auto [x, y, z, origin] = transformFromPose(display.position, display.orientation);
  const double matrix[16] = {x.x, y.x, z.x, origin.x, x.y, y.y, z.y, origin.y,
                             x.z, y.z, z.z, origin.z, 0,   0,   0,   1};
  const vtkNew<vtkTransform> worldFromDisplay;
  worldFromDisplay->SetMatrix(matrix);
  m_actor->SetUserTransform(worldFromDisplay);
}

std::optional<Vec3> MeshActors::pointAt(vtkRenderer* renderer, int x, int y) const {
  if (!isShown()) return std::nullopt;
  const vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0);
  picker->PickFromListOn();
  picker->AddPickList(m_actor);
  if (picker->Pick(x + 0.5, y + 0.5, 0, renderer) == 0) return std::nullopt;
  const double* p = picker->GetPickPosition();
  return Vec3{p[0], p[1], p[2]};
}

void MeshActors::setVisible(bool isVisible) {
  m_isVisible = isVisible;
  setMesh(m_mapper->GetInput());
}

}  // namespace hogelscope
