// SPDX-License-Identifier: BSD-3-Clause
// The display's viewing zone in the 3-D scene: a translucent body of the points that see the whole
// panel, and lines around those that see part of it.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "core/panel/viewing_zone.h"

class vtkRenderer;

namespace hogelscope {

class ZoneActors {
 public:
  explicit ZoneActors(vtkRenderer* renderer);

  /// Shows the zone up to `farthest` metres in front of the panel.
  void show(const PanelParams& display, double farthest);
  void setVisible(bool isVisible);
  [[nodiscard]] bool isVisible() const { return m_body->GetVisibility() != 0; }

 private:
  PanelParams m_display;
  double m_farthest = 0;
  vtkNew<vtkPolyData> m_whole;
  vtkNew<vtkPolyData> m_some;
  vtkNew<vtkActor> m_body;
  vtkNew<vtkActor> m_someEdges;
};

}  // namespace hogelscope
