// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/zone_actors.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTrivialProducer.h>

#include "gui/scene/scene_actor.h"

namespace hogelscope {

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
