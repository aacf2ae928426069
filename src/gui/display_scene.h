// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene: the panel with its hogel grid, and the frusta of all states, the current one
// marked.
#pragma once

#include <vtkNew.h>

#include <vector>

#include "core/session.h"

class vtkActor;
class vtkAppendPolyData;
class vtkAxesActor;
class vtkCameraFrustumSource;
class vtkHogelDisplaySource;
class vtkOrientationMarkerWidget;
class vtkRenderer;

namespace hogelscope {

class VtkWidget;

class DisplayScene {
 public:
  explicit DisplayScene(VtkWidget& widget);
  ~DisplayScene();
  DisplayScene(const DisplayScene&) = delete;
  DisplayScene& operator=(const DisplayScene&) = delete;

  /// `display` has its hogels resolved. States without a camera frame are left out.
  void show(const DisplayParams& display, const std::vector<CameraState>& states,
            std::size_t current);
  /// Looks at all of it from the front, a little from the right and above.
  void fit();
  [[nodiscard]] vtkRenderer* renderer() const { return m_renderer; }

 private:
  VtkWidget& m_widget;
  vtkNew<vtkRenderer> m_renderer;
  vtkNew<vtkHogelDisplaySource> m_display;
  vtkNew<vtkAppendPolyData> m_otherFrusta;
  vtkNew<vtkCameraFrustumSource> m_currentFrustum;
  vtkNew<vtkActor> m_otherActor;
  vtkNew<vtkActor> m_currentActor;
  vtkNew<vtkAxesActor> m_axes;
  vtkNew<vtkOrientationMarkerWidget> m_marker;
};

}  // namespace hogelscope
