// SPDX-License-Identifier: BSD-3-Clause
// The panel in the 3-D scene: what the scene's eye sees on it or a plain one with its hogel grid,
// the world's axes and a scale bar.
#pragma once

#include <vtkNew.h>

#include "core/optics/display.h"

class vtkActor;
class vtkAxesActor;
class vtkHogelDisplaySource;
class vtkImageData;
class vtkRenderer;
class vtkScaleBarSource;
class vtkTextActor;
class vtkTexture;

namespace hogelscope {

class PanelActors {
 public:
  explicit PanelActors(vtkRenderer* renderer);
  ~PanelActors();
  PanelActors(const PanelActors&) = delete;
  PanelActors& operator=(const PanelActors&) = delete;

  void setDisplay(const DisplayParams& display);
  /// RGB over the whole panel; null: none yet, or not to be shown. Without one the grid is there.
  void setImage(vtkImageData* image);
  /// Also over an image.
  void setGridVisible(bool isVisible);
  void setAxesVisible(bool areVisible);
  void setScaleBarVisible(bool isVisible);
  /// Grid lines stay so far apart, in metres.
  void setGridSpacing(double spacing);
  /// How many lines the grid has now; 0 where it is not shown.
  [[nodiscard]] int gridLines() const;

 private:
  void updateGrid();
  void addAxes(vtkRenderer* renderer);
  void addScaleBar(vtkRenderer* renderer);

  vtkNew<vtkHogelDisplaySource> m_source;
  vtkNew<vtkActor> m_panel;
  vtkNew<vtkActor> m_grid;
  vtkNew<vtkTexture> m_image;
  vtkNew<vtkAxesActor> m_axes;
  vtkNew<vtkScaleBarSource> m_barSource;
  vtkNew<vtkActor> m_bar;
  vtkNew<vtkTextActor> m_barLabel;
  bool m_isGridWanted = false;
};

}  // namespace hogelscope
