// SPDX-License-Identifier: BSD-3-Clause
// A live scene's triangles in the 3-D scene, behind and in front of the panel.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include "core/optics/display.h"
#include "sdk/hogelscope/plugin.h"

class vtkRenderer;

namespace hogelscope {

using VtkMesh = vtkSmartPointer<vtkPolyData>;

/// Returns triangles with a colour for each point, or a box around them where there are more than
/// half a million; null without any.
VtkMesh toVtkMesh(const plugin::Triangles& triangles);

class MeshActors {
 public:
  explicit MeshActors(vtkRenderer* renderer);

  /// In the display frame; null: none.
  void setMesh(const VtkMesh& mesh);
  void setDisplay(const DisplayParams& display);
  void setVisible(bool isVisible);
  [[nodiscard]] bool isShown() const;
  /// In the world: least and most x, y, z.
  [[nodiscard]] const double* bounds() const { return m_actor->GetBounds(); }

 private:
  vtkNew<vtkPolyDataMapper> m_mapper;
  vtkNew<vtkActor> m_actor;
  DisplayParams m_display;  ///< at the world's origin, as an actor is by itself
  bool m_isVisible = true;
};

}  // namespace hogelscope
