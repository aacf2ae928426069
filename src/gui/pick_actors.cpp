// SPDX-License-Identifier: BSD-3-Clause
// What is picked, in the 3-D scene.
#include "gui/pick_actors.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkTrivialProducer.h>

#include "gui/scene_actor.h"
#include "vtk/vtkHogelFieldSource.h"

namespace hogelscope {

PickActors::PickActors(vtkRenderer* renderer) {
  addToScene(renderer, m_rays, m_field->GetOutputPort(0), {0.35, 0.80, 0.95}, SceneLevel::onPanel);
  addToScene(renderer, m_end, m_field->GetOutputPort(1), {1, 1, 1}, SceneLevel::panel);
  m_end->SetTexture(m_picture);  // without interpolation: a directional pixel is a square
  const vtkNew<vtkTrivialProducer> line;
  line->SetOutput(m_line);
  addToScene(renderer, m_ray, line->GetOutputPort(), {1.00, 0.25, 0.45}, SceneLevel::onPanel);
  m_ray->GetProperty()->SetLineWidth(2);
  m_ray->GetProperty()->RenderLinesAsTubesOn();  // plain lines are one pixel wide
  hideHogel();
  hideRay();
}

PickActors::~PickActors() = default;

void PickActors::showHogel(const DisplayParams& display, int i, int j, vtkImageData* picture) {
  m_field->SetHogel(display, i, j);
  m_picture->SetInputData(picture);
  m_rays->VisibilityOn();
  m_end->VisibilityOn();
}

void PickActors::showRay(const Vec3& from, const Vec3& to) {
  const vtkNew<vtkPoints> points;
  points->InsertNextPoint(from.x, from.y, from.z);
  points->InsertNextPoint(to.x, to.y, to.z);
  const vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1});
  m_line->SetPoints(points);
  m_line->SetLines(lines);
  m_ray->VisibilityOn();
}

void PickActors::hideHogel() {
  m_rays->VisibilityOff();
  m_end->VisibilityOff();
}

void PickActors::hideRay() {
  m_ray->VisibilityOff();
}

bool PickActors::hasHogel() const {
  return m_end->GetVisibility() != 0;
}

bool PickActors::hasRay() const {
  return m_ray->GetVisibility() != 0;
}

}  // namespace hogelscope
