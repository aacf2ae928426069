// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/panel_actors.h"

#include <vtkCaptionActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTrivialProducer.h>
#include <QString>
#include <algorithm>

#include "gui/scene/scene_actor.h"
#include "gui/scene/scene_worker.h"

namespace hogelscope {

PanelActors::PanelActors(vtkRenderer* renderer) {
  addToScene(renderer, m_panel, m_source->GetOutputPort(0), {1, 1, 1}, SceneLevel::panel);
  addToScene(renderer, m_grid, m_source->GetOutputPort(1), {0.50, 0.58, 0.70}, SceneLevel::onPanel);
  m_image->InterpolateOn();
  addAxes(renderer);
  addScaleBar(renderer);
  setImage(nullptr);
}

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

void PanelActors::setScaleBarVisible(bool isVisible) {
  m_bar->SetVisibility(isVisible);
  m_barLabel->SetVisibility(isVisible);
}

int PanelActors::gridLines() const {
  if (m_grid->GetVisibility() == 0) return 0;
  m_source->Update();
  return int(m_source->GetOutput(1)->GetNumberOfLines());
}

namespace {

constexpr std::array<double, 3> colour{0.45, 0.70, 1.00};

/// A body between sections, with its faces as quads and its edges as lines.
struct Body {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkCellArray> edges;

  Body(const std::vector<ZoneSection>& sections, const RigidTransform& worldFromDisplay) {
    for (const auto& [z, low, high] : sections)
      for (const auto& [x, y] : {std::pair(low[0], low[1]), std::pair(high[0], low[1]),
                                 std::pair(high[0], high[1]), std::pair(low[0], high[1])}) {
        const Vec3 p = worldFromDisplay.point({x, y, z});
        points->InsertNextPoint(p.x, p.y, p.z);
      }
    for (vtkIdType section = 0; section < vtkIdType(sections.size()); ++section) {
      const vtkIdType first = 4 * section;
      const bool isAtEnd = section == 0 || section + 1 == vtkIdType(sections.size());
      if (isAtEnd) faces->InsertNextCell({first, first + 1, first + 2, first + 3});
      for (vtkIdType k = 0; k < 4; ++k) {
        const vtkIdType next = first + (k + 1) % 4;
        if (isAtEnd) edges->InsertNextCell({first + k, next});
        if (section == 0) continue;
        faces->InsertNextCell({first + k, next, next - 4, first + k - 4});
        edges->InsertNextCell({first + k, first + k - 4});
      }
    }
  }
};

void addLines(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* lines) {
  const vtkNew<vtkTrivialProducer> source;
  source->SetOutput(lines);
  addToScene(renderer, actor, source->GetOutputPort(), colour, SceneLevel::onPanel);
}

}  // namespace

ZoneActors::ZoneActors(vtkRenderer* renderer) {
  addLines(renderer, m_someEdges, m_some);
  m_someEdges->GetProperty()->SetOpacity(0.35);
  addLines(renderer, m_body, m_whole);
  m_body->GetProperty()->SetOpacity(0.07);
  // Excludes the body, which surrounds the scene's eye, from the bounds to keep depth precision.
  m_body->UseBoundsOff();
  m_someEdges->UseBoundsOff();
  setVisible(false);
}

void ZoneActors::show(const PanelParams& display, double farthest) {
  if (m_farthest == farthest && m_display == display) return;
  m_display = display;
  m_farthest = farthest;
  const RigidTransform worldFromDisplay = transformFromPose(display.position, display.orientation);
  const auto set = [&](vtkPolyData* data, ViewingZone zone, bool hasFaces) {
    const Body body(sectionsOf(display, zone, farthest), worldFromDisplay);
    data->Initialize();
    data->SetPoints(body.points);
    data->SetLines(body.edges);
    if (hasFaces) data->SetPolys(body.faces);
    data->Modified();
  };
  set(m_whole, ViewingZone::wholePanel, true);
  set(m_some, ViewingZone::someOfThePanel, false);
}

void ZoneActors::setVisible(bool isVisible) {
  m_body->SetVisibility(isVisible);
  m_someEdges->SetVisibility(isVisible);
}

}  // namespace hogelscope
