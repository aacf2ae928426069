// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_actor.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <algorithm>
#include <cmath>
#include <string>

namespace hogelscope {

void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                SceneLevel level) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  if (level == SceneLevel::panel)
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 4);
  else
    setDepth(actor, level);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void setColour(vtkProperty* property, const QColor& colour) {
  property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void setDepth(vtkActor* actor, SceneLevel level) {
  // Follows VTK's own depth; the offset is twice VTK's offset of coincident lines.
  const std::string place = "//VTK::Depth::Impl";
  std::string depth = "gl_FragCoord.z - 8.0 / 65000.0";
  if (level == SceneLevel::inFront) depth = "0.0";
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      place, true, place + "\n  gl_FragDepth = " + depth + ";\n", false);
}

std::optional<QPointF> onScreen(vtkRenderer& renderer, const Vec3& point) {
  vtkMatrix4x4* clipFromWorld = renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      renderer.GetTiledAspectRatio(), -1, 1);
  const double in[4] = {point.x, point.y, point.z, 1};
  double clip[4];
  clipFromWorld->MultiplyPoint(in, clip);
  if (!(clip[3] > 0)) return std::nullopt;
  const int* size = renderer.GetSize();
  return QPointF((1 + clip[0] / clip[3]) / 2 * size[0], (1 - clip[1] / clip[3]) / 2 * size[1]);
}

RigidTransform viewOf(vtkRenderer& renderer) {
  vtkMatrix4x4* m = renderer.GetActiveCamera()->GetViewTransformMatrix();
  const auto column = [m](int k) {
    return Vec3{m->GetElement(0, k), m->GetElement(1, k), m->GetElement(2, k)};
  };
  return {column(0), column(1), column(2), column(3)};
}

std::pair<Vec3, Vec3> lineAt(vtkRenderer& renderer, const QPointF& place) {
  const auto pointAt = [&](double depth) -> Vec3 {
    renderer.SetDisplayPoint(place.x(), renderer.GetSize()[1] - place.y(), depth);
    renderer.DisplayToWorld();
    const double* p = renderer.GetWorldPoint();
    return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
  };
  return {pointAt(0), pointAt(1)};
}

double pixelSizeAt(vtkRenderer& renderer, const Vec3& point) {
  vtkCamera* camera = renderer.GetActiveCamera();
  const int height = std::max(1, renderer.GetSize()[1]);
  if (camera->GetParallelProjection() != 0) return 2 * camera->GetParallelScale() / height;
  const auto vec3 = [](const double* p) { return Vec3{p[0], p[1], p[2]}; };
  const double depth =
      dot(point - vec3(camera->GetPosition()), vec3(camera->GetDirectionOfProjection()));
  return 2 * std::tan(radians(camera->GetViewAngle()) / 2) * std::max(0.0, depth) / height;
}

}  // namespace hogelscope
