// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a live scene in the 3-D scene, behind and in front of the panel.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include <optional>

#include "core/panel/display.h"
#include "vtk/scene_data.h"

class vtkRenderer;

namespace hogelscope {

class MeshActors {
 public:
  explicit MeshActors(vtkRenderer* renderer);

  /// Sets the mesh in the display frame; null: none.
  void setMesh(const VtkMesh& mesh);
  void setDisplay(const DisplayParams& display);
  void setVisible(bool isVisible);
  [[nodiscard]] bool isShown() const { return m_actor->GetVisibility() != 0; }
  /// Returns the nearest point of the mesh's triangles under a pixel that counts from the lower
  /// left, in the world.
  std::optional<Vec3> pointAt(vtkRenderer* renderer, int x, int y) const;
  /// Returns the mesh's bounds in the world, as xMin, xMax, yMin, yMax, zMin, zMax.
  [[nodiscard]] const double* bounds() const { return m_actor->GetBounds(); }

 private:
  vtkNew<vtkPolyDataMapper> m_mapper;
  vtkNew<vtkActor> m_actor;
  DisplayParams m_display;  ///< the default is at the world's origin, like the actor
  bool m_isVisible = true;
};

}  // namespace hogelscope
