// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/pick_actors.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkTrivialProducer.h>

#include "gui/scene/scene_actor.h"

namespace hogelscope {

PickActors::PickActors(vtkRenderer* renderer) {
  addToScene(renderer, m_rays, m_field->GetOutputPort(0), {0.35, 0.80, 0.95}, SceneLevel::onPanel);
  addToScene(renderer, m_end, m_field->GetOutputPort(1), {1, 1, 1}, SceneLevel::panel);
  m_end->SetTexture(m_image);  // without interpolation, because directional pixels are squares
  const vtkNew<vtkTrivialProducer> line;
  line->SetOutput(m_line);
  addToScene(renderer, m_ray, line->GetOutputPort(), {1.00, 0.25, 0.45}, SceneLevel::onPanel);
  m_ray->GetProperty()->SetLineWidth(2);
  m_ray->GetProperty()->RenderLinesAsTubesOn();  // plain lines are one pixel wide
  addLabel(renderer, m_label);
  m_label->GetTextProperty()->SetBackgroundColor(0, 0, 0);
  m_label->GetTextProperty()->SetBackgroundOpacity(0.6);
  hideHogel();
  hideRay();
}

void PickActors::showHogel(const PanelParams& display, int i, int j, vtkImageData* image) {
  m_field->SetHogel(display, i, j);
  m_image->SetInputData(image);
  const Vec3 below = m_field->GetLabelPosition();
  m_label->GetPositionCoordinate()->SetValue(below.x, below.y, below.z);
  m_label->SetInput(SceneText::hogelName(i, j).toUtf8().constData());
  m_label->VisibilityOn();
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
  m_label->VisibilityOff();
}

std::string PickActors::label() const {
  return m_label->GetVisibility() != 0 ? m_label->GetInput() : "";
}

}  // namespace hogelscope
