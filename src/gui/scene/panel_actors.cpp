// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/panel_actors.h"

#include <vtkAxesActor.h>
#include <vtkCaptionActor2D.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTexture.h>

#include <QString>
#include <algorithm>

#include "gui/scene/scene_actor.h"
#include "gui/scene/scene_worker.h"
#include "vtk/vtkHogelDisplaySource.h"
#include "vtk/vtkScaleBarSource.h"

namespace hogelscope {

PanelActors::PanelActors(vtkRenderer* renderer) {
  addToScene(renderer, m_panel, m_source->GetOutputPort(0), {1, 1, 1}, SceneLevel::panel);
  addToScene(renderer, m_grid, m_source->GetOutputPort(1), {0.50, 0.58, 0.70}, SceneLevel::onPanel);
  m_image->InterpolateOn();
  addAxes(renderer);
  addScaleBar(renderer);
  setImage(nullptr);
}

PanelActors::~PanelActors() = default;

/// Adds the world's axes, which show the frame of eyes and look-at points.
void PanelActors::addAxes(vtkRenderer* renderer) {
  m_axes->SetShaftTypeToLine();
  m_axes->SetConeRadius(0.12);
  m_axes->SetNormalizedTipLength(0.08, 0.08, 0.08);
  m_axes->SetNormalizedShaftLength(0.92, 0.92, 0.92);
  for (vtkCaptionActor2D* letter :
       {m_axes->GetXAxisCaptionActor2D(), m_axes->GetYAxisCaptionActor2D(),
        m_axes->GetZAxisCaptionActor2D()}) {
    letter->GetTextActor()->SetTextScaleModeToNone();
    makePlain(letter->GetCaptionTextProperty());
  }
  renderer->AddActor(m_axes);
}

void PanelActors::addScaleBar(vtkRenderer* renderer) {
  addToScene(renderer, m_bar, m_barSource->GetOutputPort(), {0.85, 0.85, 0.85},
             SceneLevel::onPanel);
  addLabel(renderer, m_barLabel);
}

void PanelActors::setDisplay(const DisplayParams& display) {
  m_source->SetDisplay(display);
  m_barSource->SetDisplay(display);
  const Vec3 label = m_barSource->GetLabelPosition();
  m_barLabel->GetPositionCoordinate()->SetValue(label.x, label.y, label.z);
  m_barLabel->SetInput((QString::number(m_barSource->GetLength()) + " m").toUtf8().constData());
  const double length = 0.65 * std::max(display.size[0], display.size[1]);  // beyond its edges
  m_axes->SetTotalLength(length, length, length);
}

void PanelActors::setImage(vtkImageData* image) {
  m_image->SetInputData(image);
  m_panel->SetTexture(image != nullptr ? m_image.Get() : nullptr);
  updateGrid();
  const auto [r, g, b] = SceneWorker::panelColour;
  // A texture is multiplied by the colour.
  if (image != nullptr)
    m_panel->GetProperty()->SetColor(1, 1, 1);
  else
    m_panel->GetProperty()->SetColor(r / 255.0, g / 255.0, b / 255.0);
}

void PanelActors::setGridVisible(bool isVisible) {
  m_isGridWanted = isVisible;
  updateGrid();
}

void PanelActors::updateGrid() {
  m_grid->SetVisibility(m_isGridWanted || m_panel->GetTexture() == nullptr);
}

void PanelActors::setAxesVisible(bool areVisible) {
  m_axes->SetVisibility(areVisible);
}

void PanelActors::setScaleBarVisible(bool isVisible) {
  m_bar->SetVisibility(isVisible);
  m_barLabel->SetVisibility(isVisible);
}

void PanelActors::setGridSpacing(double spacing) {
  m_source->SetSpacing(spacing);
}

int PanelActors::gridLines() const {
  if (m_grid->GetVisibility() == 0) return 0;
  m_source->Update();
  return int(m_source->GetOutput(1)->GetNumberOfLines());
}

}  // namespace hogelscope
