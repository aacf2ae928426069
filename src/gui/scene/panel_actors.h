// SPDX-License-Identifier: BSD-3-Clause
// The panel in the 3-D scene: the image seen from the scene's eye, or a plain panel with its hogel
// grid; the viewing zone, the world's axes and a scale bar.
#pragma once

#include <vtkActor.h>
#include <vtkAxesActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTextActor.h>
#include <vtkTexture.h>

#include "core/panel/display.h"
#include "core/panel/viewing_zone.h"
#include "vtk/vtkHogelDisplaySource.h"
#include "vtk/vtkScaleBarSource.h"

class vtkImageData;
class vtkRenderer;

namespace hogelscope {

class PanelActors {
 public:
  explicit PanelActors(vtkRenderer* renderer);

  void setDisplay(const DisplayParams& display);
  /// Sets an RGB image of the whole panel; null: none. The grid is shown without an image.
  void setImage(vtkImageData* image);
  /// Shows the grid over an image too.
  void setGridVisible(bool isVisible);
  void setAxesVisible(bool areVisible) { m_axes->SetVisibility(areVisible); }
  void setScaleBarVisible(bool isVisible);
  /// Sets the least distance between grid lines, in metres.
  void setGridSpacing(double spacing) { m_source->SetSpacing(spacing); }
  /// Returns the number of grid lines; 0 if the grid is hidden.
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

/// The display's viewing zone in the 3-D scene: a translucent body of the points that see the whole
/// panel, and lines around those that see part of it.
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
