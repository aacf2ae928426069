// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/panel_actors.h"

#include <vtkImageData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTrivialProducer.h>
#include <algorithm>
#include <cmath>

#include "gui/scene/scene_actor.h"
#include "vtk/scene_data.h"

namespace hogelscope {

PanelActors::PanelActors(vtkRenderer* renderer) {
  addToScene(renderer, m_panel, m_source->GetOutputPort(0), SceneLevel::panel);
  addToScene(renderer, m_grid, m_source->GetOutputPort(1), SceneLevel::onPanel);
  m_image->InterpolateOn();
  addToScene(renderer, m_edge, m_source->GetOutputPort(0), SceneLevel::onPanel);
  m_edge->GetProperty()->SetRepresentationToWireframe();
  m_edge->GetProperty()->SetLineWidth(2);
  m_edge->GetProperty()->RenderLinesAsTubesOn();  // plain lines are one pixel wide
  setImage(nullptr);
}

void PanelActors::setColours(const Tokens& colours) {
  m_colours = &colours;
  updateGrid();
  setColour(m_edge->GetProperty(), colours.text);
}

void PanelActors::setDisplay(const DisplayParams& display) {
  m_source->SetDisplay(display);
  m_isSheet = display.sheet.has_value();
  updateGrid();
}

void PanelActors::setImage(vtkImageData* image) {
  m_image->SetInputData(image);
  m_panel->SetTexture(image != nullptr ? m_image.Get() : nullptr);
  updateGrid();
  const auto [r, g, b] = panelColour;
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
  setColour(m_grid->GetProperty(), m_isSheet ? m_colours->good : m_colours->text3);
  m_grid->SetVisibility(m_isGridWanted || m_isSheet || m_panel->GetTexture() == nullptr);
}

int PanelActors::gridLines() const {
  if (m_grid->GetVisibility() == 0) return 0;
  m_source->Update();
  return int(m_source->GetOutput(1)->GetNumberOfLines());
}

namespace {

void addLines(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* lines) {
  const vtkNew<vtkTrivialProducer> source;
  source->SetOutput(lines);
  addToScene(renderer, actor, source->GetOutputPort(), SceneLevel::onPanel);
}

}  // namespace

std::vector<Vec3> coneOf(const PanelParams& display, int times, double z) {
  const SheetParams& params = display.sheet->calibration.params;
  const RigidTransform world = transformFromPose(display.position, display.orientation);
  const double side = times * z * std::tan(radians(params.cone) / 2);
  const double top = display.size[1] / 2;
  const auto corner = [&](double across, double y) {
    return world.point({across - y / params.slope, y, z});
  };
  return {corner(-side, -top), corner(side, -top), corner(side, top), corner(-side, top)};
}

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

void ZoneActors::setColours(const Tokens& colours) {
  setColour(m_someEdges->GetProperty(), colours.good);
  setColour(m_body->GetProperty(), colours.good);
}

void ZoneActors::show(const PanelParams& display, double farthest) {
  if (m_farthest == farthest && m_display == display) return;
  m_display = display;
  m_farthest = farthest;
  const auto body = [&](vtkPolyData* data, ViewingZone zone) {
    const bool isWhole = zone == ViewingZone::wholePanel;
    std::vector<std::vector<Vec3>> corners;
    if (display.sheet)
      for (const double z : {0.0, farthest}) corners.push_back(coneOf(display, isWhole ? 1 : 3, z));
    else
      for (const ZoneSection& section : sectionsOf(display, zone, farthest))
        corners.push_back(cornersOf(display, section));
    setBody(data, corners, isWhole);
  };
  body(m_whole, ViewingZone::wholePanel);
  body(m_some, ViewingZone::someOfThePanel);
}

void ZoneActors::setVisible(bool isVisible) {
  m_body->SetVisibility(isVisible);
  m_someEdges->SetVisibility(isVisible);
}

}  // namespace hogelscope
