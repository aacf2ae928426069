// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/mesh_actors.h"

#include <vtkCellPicker.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <utility>

namespace hogelscope {

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
