// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/pick_actors.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTrivialProducer.h>

#include "gui/scene/scene_actor.h"
#include "picture/scene_text.h"

namespace hogelscope {

PickActors::PickActors(vtkRenderer* renderer) {
  addToScene(renderer, m_rays, m_field->GetOutputPort(0), SceneLevel::onPanel);
  addToScene(renderer, m_end, m_field->GetOutputPort(1), SceneLevel::panel);
  m_end->SetTexture(m_image);  // without interpolation, because directional pixels are squares
  const vtkNew<vtkTrivialProducer> line;
  line->SetOutput(m_line);
  addToScene(renderer, m_ray, line->GetOutputPort(), SceneLevel::onPanel);
  m_ray->GetProperty()->SetLineWidth(2);
  m_ray->GetProperty()->RenderLinesAsTubesOn();  // plain lines are one pixel wide
  hideHogel();
  hideRay();
}

void PickActors::setColours(const Tokens& colours) {
  setColour(m_rays->GetProperty(), colours.focus);
  setColour(m_ray->GetProperty(), colours.series[3]);
}

void PickActors::showHogel(const PanelParams& display, int i, int j, vtkImageData* image) {
  m_field->SetHogel(display, i, j);
  m_image->SetInputData(image);
  m_label = SceneText::hogelName(i, j).toStdString();
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
  m_label.clear();
}

}  // namespace hogelscope
