// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/display_scene.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>

#include <QLineF>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/optics/scene_eyes.h"
#include "core/panel/design_numbers.h"
#include "core/panel/viewing_zone.h"
#include "gui/scene/scene_actor.h"
#include "gui/scene/scene_overlay.h"
#include "gui/scene/vtk_widget.h"
#include "picture/scene_text.h"
#include "vtk/line_picker.h"

namespace hogelscope {

namespace {

Vec3 vec3(const double* p) {
  return {p[0], p[1], p[2]};
}

/// Returns the corners of the panel's outline at the depths between which content is sharp for an
/// eye; without a plane where there is no limit.
std::vector<std::vector<Vec3>> depthPlanes(const PanelParams& display, const Vec3& eye) {
  std::vector<std::vector<Vec3>> planes;
  if (!hasDirections(display) || display.hogels[0] < 1 || display.directions[0] < 1) return planes;
  const DesignNumbers numbers = designNumbers(display, eye);
  const std::array<double, 2> half{display.size[0] / 2, display.size[1] / 2};
  for (const double z : {numbers.depthFront, -numbers.depthBehind})
    if (z != 0 && std::isfinite(z))
      planes.push_back(cornersOf(display, {z, {-half[0], -half[1]}, half}));
  return planes;
}

}  // namespace

DisplayScene::DisplayScene(VtkWidget& widget, QObject* parent)
    : QObject(parent),
      m_widget(widget),
      m_panel(m_renderer),
      m_frusta(m_renderer),
      m_mesh(m_renderer),
      m_zone(m_renderer),
      m_twin(m_renderer),
      m_picked(m_renderer),
      m_handles(m_renderer, widget.interactor(), nullptr),
      m_eyeTimer(new QTimer(this)) {
  m_widget.renderWindow()->AddRenderer(m_renderer);
  setColours(tokens(), tokens().canvas);
  connect(&m_widget, &VtkWidget::coloursChanged, this,
          [this] { setColours(tokens(), tokens().canvas); });
  connect(&m_widget, &VtkWidget::painted, this,
          [this](QPainter& painter) { paintOver(painter, true); });
  connect(&m_handles, &SceneHandles::arrowsChanged, &m_widget, qOverload<>(&QWidget::update));
  m_eyeTimer->setSingleShot(true);
  connect(m_eyeTimer, &QTimer::timeout, this, &DisplayScene::adjustToEye);
  connect(&m_widget, &VtkWidget::resized, this, &DisplayScene::keepFitted);
  // Restarts the timer, because a turn modifies the camera several times.
  m_renderer->GetActiveCamera()->AddObserver(vtkCommand::ModifiedEvent, m_eyeTimer,
                                             static_cast<void (QTimer::*)()>(&QTimer::start));
}

DisplayScene::~DisplayScene() {
  m_renderer->GetActiveCamera()->RemoveAllObservers();
}

void DisplayScene::setColours(const Tokens& colours, const QColor& background) {
  m_colours = &colours;
  m_background = background;
  m_renderer->SetBackground(background.redF(), background.greenF(), background.blueF());
  m_renderer->SetBackgroundAlpha(background.alphaF());
  m_panel.setColours(colours);
  m_frusta.setColours(colours);
  m_zone.setColours(colours);
  m_twin.setColours(colours);
  m_picked.setColours(colours);
  m_widget.redraw();
}

void DisplayScene::paintOver(QPainter& painter, bool hasArrows) const {
  const double ratio = m_widget.devicePixelRatioF();
  const RigidTransform view = viewOf(*m_renderer);
  SceneOverlay overlay;
  overlay.axes = {view.xAxis, view.yAxis, view.zAxis};
  if (hasArrows) overlay.arrows = m_handles.arrows();
  const double reach = 0.65 * std::max(m_display.size[0], m_display.size[1]);  // beyond its edges
  if (m_hasAxes)
    std::ranges::copy(arrowsAt(*m_renderer, {}, reach), std::back_inserter(overlay.arrows));
  for (AxisArrow& arrow : overlay.arrows) {
    arrow.from /= ratio;
    arrow.to /= ratio;
  }
  if (m_hasScaleBar) overlay.pixelSize = ratio * pixelSizeAt(*m_renderer, m_display.position);
  const auto outline = [&](const std::vector<Vec3>& corners) {
    QPolygonF polygon;
    for (const Vec3& corner : corners)
      if (const auto at = onScreen(*m_renderer, corner)) polygon << *at / ratio;
    return polygon.size() == qsizetype(corners.size()) ? polygon : QPolygonF();
  };
  if (m_hasDepths)
    for (const std::vector<Vec3>& plane : m_depths) overlay.sharpDepths.push_back(outline(plane));
  overlay.isSheet = m_display.sheet.has_value();
  overlay.wholeZone = outline(m_wholeZone);
  overlay.someZone = outline(m_someZone);
  if (!QRectF(m_widget.rect()).contains(overlay.someZone.boundingRect())) overlay.someZone.clear();
  const PsnrScale& psnr = m_frusta.psnr();
  overlay.psnr = psnr.range();
  QColor eyeColour = m_colours->eye;
  if (psnr.hasValue(m_current)) {  // the current frustum keeps its colour
    const auto [r, g, b] = psnr.colour(m_current);
    eyeColour = QColor(r, g, b);
  }
  for (const auto& [ball, colour] :
       {std::pair(SceneBall::mesh, m_colours->good), std::pair(SceneBall::lookat, m_colours->text),
        std::pair(SceneBall::eye, eyeColour)})
    if (const auto at = m_handles.ballAt(ball)) overlay.balls.emplace_back(*at / ratio, colour);
  for (const Vec3& point : m_measured)
    if (const auto at = onScreen(*m_renderer, point)) overlay.measured.push_back(*at / ratio);
  if (m_measured.size() == 2)
    overlay.distance = SceneText::length(length(m_measured[1] - m_measured[0]));
  if (const std::string label = m_picked.label(); !label.empty())
    if (const auto at = onScreen(*m_renderer, m_picked.labelPlace())) {
      overlay.label = QString::fromStdString(label);
      overlay.labelPlace = *at / ratio;
    }
  overlay.paint(painter, m_widget.size(), *m_colours, m_background);
}

void DisplayScene::redraw() {
  if (m_drawnAt == changedAt()) return m_widget.update();  // what is painted over it
  m_renderer->ResetCameraClippingRange();
  m_drawnAt = changedAt();
  m_widget.redraw();
}

/// Returns VTK's time of the last change of the eye or of anything in the scene.
vtkMTimeType DisplayScene::changedAt() const {
  vtkMTimeType at = m_renderer->GetActiveCamera()->GetMTime();
  vtkPropCollection* props = m_renderer->GetViewProps();
  vtkCollectionSimpleIterator position;
  props->InitTraversal(position);
  while (vtkProp* prop = props->GetNextProp(position)) at = std::max(at, prop->GetRedrawMTime());
  return at;
}

void DisplayScene::show(const PanelParams& display, const std::vector<CameraState>& states,
                        std::size_t current) {
  m_display = display;
  m_panel.setDisplay(display);
  m_mesh.setDisplay(display);
  m_frusta.show(display, states, current);
  double farthest = 2 * std::max(display.size[0], display.size[1]);
  for (const CameraState& state : states)
    farthest = std::max(farthest, 1.1 * length(state.camera.eye - display.position));
  m_current = current;
  const bool hasCurrent = current < states.size() && hasFrame(states[current].camera);
  m_zone.show(display, farthest);
  const Vec3 eye = hasCurrent ? states[current].camera.eye : display.position;
  const auto outline = [&](ViewingZone zone, int cones) {
    return display.sheet ? coneOf(display, cones, display.sheet->viewingDistance)
                         : zoneAt(display, zone, eye);
  };
  m_wholeZone = outline(ViewingZone::wholePanel, 1);
  m_someZone = outline(ViewingZone::someOfThePanel, 3);
  m_depths = depthPlanes(display, eye);
  m_marks = panelCorners();
  for (const CameraState& state : states) m_marks.push_back(state.camera.eye);
  const auto place = [&](Vec3 CameraParams::*point) {
    return hasCurrent ? std::optional(states[current].camera.*point) : std::nullopt;
  };
  m_handles.show(SceneBall::eye, place(&CameraParams::eye));
  m_handles.show(SceneBall::lookat, place(&CameraParams::lookat));
  if (hasCurrent) m_marks.push_back(states[current].camera.lookat);
  redraw();
}

double DisplayScene::pixelOnPanel() const {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  if (camera->GetParallelProjection() != 0)
    return 2 * camera->GetParallelScale() / std::max(1, m_widget.deviceSize().height());
  return radians(m_renderer->GetActiveCamera()->GetViewAngle()) /
         std::max(1, m_widget.deviceSize().height()) * distanceToPanel(m_display, eye().eye);
}

void DisplayScene::adjustToEye() {
  constexpr double leastPixels = 8;  // between two grid lines
  m_panel.setGridSpacing(leastPixels * pixelOnPanel());
  redraw();
  Q_EMIT eyeChanged();
}

void DisplayScene::keepFitted() {
  if (m_fitted == eye()) fitDistance();
  m_eyeTimer->start();
}

void DisplayScene::look(const Vec3& target, const Vec3& from, const Vec3& up) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->SetFocalPoint(target.x, target.y, target.z);
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetViewUp(up.x, up.y, up.z);
}

std::vector<Vec3> DisplayScene::panelCorners() const {
  const auto [width, height] = m_display.size;
  return cornersOf(m_display, {0, {-width / 2, -height / 2}, {width / 2, height / 2}});
}

/// Returns the corners of panel, frusta, mesh and the zone's outline. Axes and handles are not
/// fitted.
std::vector<Vec3> DisplayScene::corners() const {
  std::vector<Vec3> points = m_frusta.points();
  const auto addBox = [&](const double* bounds) {
    for (const int x : {0, 1})
      for (const int y : {2, 3})
        for (const int z : {4, 5}) points.push_back({bounds[x], bounds[y], bounds[z]});
  };
  if (m_mesh.isShown()) addBox(m_mesh.bounds());
  std::ranges::copy(panelCorners(), std::back_inserter(points));
  std::ranges::copy(m_wholeZone, std::back_inserter(points));
  return points;
}

/// Moves the eye forwards, backwards and sideways until everything fits the window.
void DisplayScene::fitDistance() {
  constexpr double fov = 30;      // degrees, vertical
  constexpr double share = 0.94;  // of the window, as a margin
  const QSize window = m_widget.deviceSize();
  const double tangent = share * std::tan(radians(fov) / 2);
  const double aspect = double(std::max(1, window.width())) / std::max(1, window.height());
  const auto [right, up, towards, from] = viewOf(*m_renderer).inverse();
  const std::vector<Vec3> points = corners();
  const RigidTransform frame{right, up, towards, {}};
  const FittedEye fitted = fittedEye(points, frame, {aspect * tangent, tangent});
  vtkCamera* camera = m_renderer->GetActiveCamera();
  look(fitted.target, fitted.eye, up);
  camera->SetViewAngle(fov);
  if (camera->GetParallelProjection() != 0) {
    const auto [target, scale] = fittedParallel(points, frame, aspect);
    look(target, target + (fitted.eye - fitted.target), up);
    camera->SetParallelScale(scale / share);
  }
  m_fitted = eye();
  redraw();
}

void DisplayScene::fit() {
  m_fitted == eye() ? reset() : fitDistance();
}

void DisplayScene::reset() {
  const double size = std::max(m_display.size[0], m_display.size[1]);
  look(m_display.position, m_display.position + size * Vec3{-0.85, 0.5, 2.5}, {0, 1, 0});
  fitDistance();
}

void DisplayScene::lookFrom(SceneSide side) {
  const auto [right, up, front, centre] =
      transformFromPose(m_display.position, m_display.orientation);
  const double far = 2 * std::max(m_display.size[0], m_display.size[1]);
  if (side == SceneSide::front) look(centre, centre + far * front, up);
  if (side == SceneSide::back) look(centre, centre - far * front, up);
  if (side == SceneSide::top) look(centre, centre + far * up, -1.0 * front);
  if (side == SceneSide::bottom) look(centre, centre - far * up, front);
  if (side == SceneSide::right) look(centre, centre + far * right, up);
  if (side == SceneSide::left) look(centre, centre - far * right, up);
  fitDistance();
}

/// Switches the projection; the panel keeps its size on the screen.
void DisplayScene::setParallel(bool isParallel) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  const double half = std::tan(radians(camera->GetViewAngle()) / 2);
  if (isParallel && camera->GetParallelProjection() == 0)
    camera->SetParallelScale(camera->GetDistance() * half);
  if (!isParallel && camera->GetParallelProjection() != 0) {
    const CameraParams from = eye();
    const Vec3 towards = normalise(from.eye - from.lookat);
    look(from.lookat, from.lookat + camera->GetParallelScale() / half * towards, from.up);
  }
  camera->SetParallelProjection(isParallel);
  redraw();
}

void DisplayScene::turn(double right, double up) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->Azimuth(right);
  camera->Elevation(up);
  camera->OrthogonalizeViewUp();
  redraw();
}

void DisplayScene::approach(double factor) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  if (camera->GetParallelProjection() != 0)
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  else
    camera->Dolly(factor);
  redraw();
}

void DisplayScene::lookThrough(const CameraState& state) {
  if (!hasFrame(state.camera)) return;
  look(state.camera.lookat, state.camera.eye, state.camera.up);
  const double focal = Camera(state.camera, state.intrinsics).focalLength().y;
  m_renderer->GetActiveCamera()->SetViewAngle(2 * std::atan(state.camera.res[1] / 2.0 / focal) *
                                              180 / std::numbers::pi);
  redraw();
}

CameraParams DisplayScene::eye() const {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  CameraParams eye;
  eye.eye = vec3(camera->GetPosition());
  eye.lookat = vec3(camera->GetFocalPoint());
  eye.up = vec3(camera->GetViewUp());
  eye.fov = camera->GetViewAngle();
  return eye;
}

Vec3 DisplayScene::viewpoint() const {
  const CameraParams from = eye();
  if (m_renderer->GetActiveCamera()->GetParallelProjection() == 0) return from.eye;
  const double far = 1e4 * std::max(m_display.size[0], m_display.size[1]);
  return from.lookat + far * normalise(from.eye - from.lookat);
}

std::vector<int> DisplayScene::statesAt(int x, int y) const {
  const QSize size = m_widget.deviceSize();
  constexpr double tolerance = 4;  // pixels
  return m_frusta.statesAt(m_renderer, {x + 0.5, y + 0.5, tolerance, size.width(), size.height()});
}

std::optional<Vec3> DisplayScene::pointAt(int x, int y) const {
  constexpr double tolerance = 8;  // pixels
  const QPointF place = m_widget.fromUpperLeft(x, y);
  std::vector<std::pair<double, Vec3>> found;  // distances, on the screen and then from the eye
  for (const Vec3& mark : m_marks)
    if (const auto at = onScreen(*m_renderer, mark))
      if (const double way = QLineF(*at, place).length(); way <= tolerance)
        found.emplace_back(way, mark);
  const auto nearest = [&] { return std::ranges::min(found, {}, &std::pair<double, Vec3>::first); };
  if (!found.empty()) return nearest().second;
  const Vec3 from = lineAt(*m_renderer, place).first;
  const auto add = [&](const Vec3& point) { found.emplace_back(length(point - from), point); };
  if (const std::optional<Hit> hogel = hogelAt(x, y)) {
    const Vec2 middle = Display(m_display).position(hogel->i, hogel->j);
    add(transformFromPose(m_display.position, m_display.orientation)
            .point({middle.x, middle.y, 0}));
  }
  if (const std::optional<Vec3> point = m_mesh.pointAt(m_renderer, x, y)) add(*point);
  return found.empty() ? std::nullopt : std::optional(nearest().second);
}

std::optional<Hit> DisplayScene::hogelAt(int x, int y) const {
  if (m_display.hogels[0] < 1 || m_display.directions[0] < 1) return std::nullopt;
  const Display display(m_display);
  const auto [from, to] = lineAt(*m_renderer, m_widget.fromUpperLeft(x, y));
  const RigidTransform& displayFromWorld = display.displayFromWorld();
  const std::optional<Hit> place =
      display.intersectPlane(displayFromWorld.point(from), displayFromWorld.direction(to - from));
  return place && display.isOnPanel(*place) ? place : std::nullopt;
}

}  // namespace hogelscope
