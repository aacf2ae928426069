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

#include "core/panel/viewing_zone.h"

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

namespace {

QString number(double value, int decimals) {
  return QString::number(value, 'f', decimals);
}

int floorIndex(double index) {
  return static_cast<int>(std::floor(index));
}

}  // namespace

QString SceneText::eye(const CameraState& state, const PanelParams& display) {
  const QString name = QString::fromStdString(state.camera.name);
  const double share = shareSeenFrom(display, state.camera.eye);
  if (share == 0) return tr("%1: ⚠ outside the viewing zone, no hogel lights this eye").arg(name);
  return tr("%1: %2 % of the panel lights this eye").arg(name, number(100 * share, 1));
}

QString SceneText::pixel(int x, int y, const PixelTrace& trace) {
  const std::string_view end = words(trace.end);
  QString text = tr("Pixel (%1, %2): %3")
                     .arg(x)
                     .arg(y)
                     .arg(QString::fromUtf8(end.data(), qsizetype(end.size())));
  if (trace.colour)
    text += tr(" · colour %1 %2 %3 (of 255)")
                .arg(number(trace.colour->r, 1), number(trace.colour->g, 1),
                     number(trace.colour->b, 1));
  if (trace.taps > 0) text += tr(" · %n leakage taps", "", trace.taps);
  return text;
}

QString SceneText::ray(const PixelTrace& trace) {
  if (trace.end == RayEnd::noRay) return {};
  const auto point = [](const Vec3& p) {
    return tr("(%1, %2, %3) m").arg(number(p.x, 4), number(p.y, 4), number(p.z, 4));
  };
  QString text = tr("\nray from %1 to %2").arg(point(trace.eye), point(trace.target));
  if (!trace.place) return text;
  const Hit& at = *trace.place;
  if (trace.end != RayEnd::misses)
    text += tr("\nhogel i %1, j %2 · direction u %3, v %4 (at %5, %6, %7, %8)")
                .arg(floorIndex(at.i))
                .arg(floorIndex(at.j))
                .arg(floorIndex(at.u))
                .arg(floorIndex(at.v))
                .arg(number(at.i, 2), number(at.j, 2), number(at.u, 2), number(at.v, 2));
  return text + tr("\npanel x %1 m, y %2 m · slopes dx/dz %3, dy/dz %4")
                    .arg(number(trace.position.x, 4), number(trace.position.y, 4),
                         number(trace.slopes.x, 4), number(trace.slopes.y, 4));
}

QString SceneText::verdict(const PixelTrace& trace, const PanelParams& display) {
  switch (fateOf(trace)) {
    case PixelFate::noRay:
      return tr(
          "Black, no ray: the lens folds nearer to the centre, so that no light gets to this "
          "pixel.");
    case PixelFate::dark:
      return tr("Black, dark content: it sees the display, which sends no light this way.");
    case PixelFate::lit:
      return tr("Sees the display.");
    case PixelFate::outside:
      break;
  }
  if (!trace.place)
    return tr("Black, outside the viewing zone: its ray does not come to the panel's front.");
  if (trace.end == RayEnd::misses) return tr("Black, outside the panel: its ray passes beside it.");
  return tr("Black, outside the viewing zone: the hogel lights %1° × %2°, and direction u %3, v %4 "
            "is none of its %5 × %6.")
      .arg(display.fov[0])
      .arg(display.fov[1])
      .arg(floorIndex(trace.place->u))
      .arg(floorIndex(trace.place->v))
      .arg(display.directions[0])
      .arg(display.directions[1]);
}

QString SceneText::length(double metres) {
  metres = std::round(1e6 * metres) / 1e6;  // 0 but for rounding errors is 0
  return metres != 0 && std::abs(metres) < 0.1
             ? tr("%1 mm").arg(QString::number(1000 * metres, 'g', 4))
             : tr("%1 m").arg(QString::number(metres, 'g', 4));
}

QString SceneText::measured(const std::vector<Vec3>& points) {
  if (points.empty()) return tr("Measure: click the first point. Escape ends.");
  if (points.size() == 1) return tr("Measure: click the second point.");
  const Vec3 way = points[1] - points[0];
  return tr("Distance %1 · Δx %2, Δy %3, Δz %4")
      .arg(length(hogelscope::length(way)), length(way.x), length(way.y), length(way.z));
}

QString SceneText::hogelName(int i, int j) {
  return tr("hogel %1, %2").arg(i).arg(j);
}

QString SceneText::hogel(const PanelParams& display, int i, int j) {
  const Vec2 middle = Display(display).position(i + 0.5, j + 0.5);
  return tr("Hogel i %1, j %2 at x %3 m, y %4 m: %5 × %6 directions over %7° × %8°")
      .arg(i)
      .arg(j)
      .arg(number(middle.x, 4), number(middle.y, 4))
      .arg(display.directions[0])
      .arg(display.directions[1])
      .arg(display.fov[0])
      .arg(display.fov[1]);
}

}  // namespace hogelscope
