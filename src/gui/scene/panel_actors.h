// SPDX-License-Identifier: BSD-3-Clause
// The panel in the 3-D scene: the image seen from the scene's eye, or a plain panel with its hogel
// grid; the viewing zone.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

#include <vector>

#include "core/panel/display.h"
#include "core/panel/viewing_zone.h"
#include "gui/widgets/colours.h"
#include "vtk/vtkHogelDisplaySource.h"

class vtkImageData;
class vtkRenderer;

namespace hogelscope {

class PanelActors {
 public:
  explicit PanelActors(vtkRenderer* renderer);

  void setColours(const Tokens& colours);
  void setDisplay(const DisplayParams& display);
  /// Sets an RGB image of the whole panel; null: none. The grid is shown without an image, a lens
  /// sheet's lines always.
  void setImage(vtkImageData* image);
  /// Shows the grid over an image too.
  void setGridVisible(bool isVisible);
  /// Sets the least distance between grid lines, in metres.
  void setGridSpacing(double spacing) { m_source->SetSpacing(spacing); }
  /// Returns the number of grid lines; 0 if the grid is hidden.
  [[nodiscard]] int gridLines() const;

 private:
  void updateGrid();

  vtkNew<vtkHogelDisplaySource> m_source;
  vtkNew<vtkActor> m_panel;
  vtkNew<vtkActor> m_grid;
  vtkNew<vtkActor> m_edge;
  vtkNew<vtkTexture> m_image;
  bool m_isGridWanted = false;
  bool m_isSheet = false;
  const Tokens* m_colours = &tokens();
};

/// Returns the corners, in order around it, of the place `z` metres before a lens sheet where its
/// middle shows the views `times` times side by side, as high as the panel; once is between two
/// flips. At the viewing distance this holds for the whole panel.
std::vector<Vec3> coneOf(const PanelParams& display, int times, double z);

/// The display's viewing zone in the 3-D scene: a translucent body of the points that see the whole
/// panel, and lines around those that see part of it. Of a lens sheet the body is where its middle
/// shows the views once, and the lines have the cones beside it too.
class ZoneActors {
 public:
  explicit ZoneActors(vtkRenderer* renderer);

  void setColours(const Tokens& colours);
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
