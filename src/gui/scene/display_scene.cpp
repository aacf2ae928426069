// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene: its parts, its own camera, what lies under the pointer.
#include "gui/scene/display_scene.h"

#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkRenderer.h>

#include <QTimer>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/optics/fitted_eye.h"
#include "core/optics/panel_view.h"
#include "gui/scene/vtk_widget.h"
#include "vtk/line_picker.h"

namespace hogelscope {

namespace {

Vec3 vec3(const double* p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

DisplayScene::DisplayScene(VtkWidget& widget, QObject* parent)
    : QObject(parent),
      m_widget(widget),
      m_panel(m_renderer),
      m_frusta(m_renderer),
      m_mesh(m_renderer),
      m_picked(m_renderer),
      m_handles(m_renderer, widget.interactor(), nullptr),
      m_eyeTimer(new QTimer(this)) {
  m_widget.renderWindow()->AddRenderer(m_renderer);
  m_renderer->SetBackground(0.13, 0.14, 0.17);
  m_marker->SetOrientationMarker(m_axes);
  m_marker->SetInteractor(m_widget.interactor());
  m_marker->SetViewport(0, 0, 0.2, 0.2);
  m_marker->EnabledOn();
  m_marker->InteractiveOff();
  m_eyeTimer->setSingleShot(true);
  connect(m_eyeTimer, &QTimer::timeout, this, &DisplayScene::adjustToEye);
  connect(&m_widget, &VtkWidget::resized, m_eyeTimer, [this] { m_eyeTimer->start(); });
  // A turn of the camera modifies it several times.
  m_renderer->GetActiveCamera()->AddObserver(vtkCommand::ModifiedEvent, m_eyeTimer,
                                             static_cast<void (QTimer::*)()>(&QTimer::start));
}

DisplayScene::~DisplayScene() {
  m_renderer->GetActiveCamera()->RemoveAllObservers();
  m_marker->SetInteractor(nullptr);
}

void DisplayScene::redraw() {
  m_renderer->ResetCameraClippingRange();
  m_widget.update();
}

void DisplayScene::show(const DisplayParams& display, const std::vector<CameraState>& states,
                        std::size_t current) {
  m_display = display;
  m_panel.setDisplay(display);
  m_mesh.setDisplay(display);
  m_frusta.show(display, states, current);
  const bool hasCurrent = current < states.size() && hasFrame(states[current].camera);
  if (hasCurrent)
    m_handles.showAt(states[current].camera.eye, states[current].camera.lookat);
  else
    m_handles.hide();
  redraw();
}

double DisplayScene::pixelOnPanel() const {
  return radians(m_renderer->GetActiveCamera()->GetViewAngle()) /
         std::max(1, m_widget.deviceSize().height()) * distanceToPanel(m_display, eye().eye);
}

void DisplayScene::adjustToEye() {
  constexpr double leastPixels = 8;  // between two lines of the grid
  m_panel.setGridSpacing(leastPixels * pixelOnPanel());
  m_handles.setSceneEye(eye().eye);
  m_widget.update();
  Q_EMIT eyeChanged();
}

void DisplayScene::look(const Vec3& target, const Vec3& from, const Vec3& up) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->SetFocalPoint(target.x, target.y, target.z);
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetViewUp(up.x, up.y, up.z);
}

/// Panel, frusta and mesh; the world's axes, balls and labels are not worth the room.
std::vector<Vec3> DisplayScene::corners() const {
  std::vector<Vec3> points = m_frusta.points();
  const auto addBox = [&](const double* bounds) {
    for (const int x : {0, 1})
      for (const int y : {2, 3})
        for (const int z : {4, 5}) points.push_back({bounds[x], bounds[y], bounds[z]});
  };
  if (m_mesh.isShown()) addBox(m_mesh.bounds());
  const RigidTransform worldFromDisplay =
      transformFromPose(m_display.position, m_display.orientation);
  constexpr double scaleBar = 0.12;  // below the panel, with its label
  const auto [width, height] = m_display.size;
  for (const double x : {-width / 2, width / 2})
    for (const double y : {-height / 2 - scaleBar * std::max(width, height), height / 2})
      points.push_back(worldFromDisplay.point({x, y, 0}));
  return points;
}

/// Goes back or forth, and across, until all of it fills the window.
void DisplayScene::fitDistance() {
  constexpr double fov = 30;      // degrees, down
  constexpr double share = 0.94;  // of the window, so that nothing touches its edges
  const QSize window = m_widget.deviceSize();
  const double tangent = share * std::tan(radians(fov) / 2);
  const double aspect = double(std::max(1, window.width())) / std::max(1, window.height());
  const CameraParams from = eye();
  const Vec3 towards = normalise(from.eye - from.lookat);
  const Vec3 right = normalise(cross(from.up, towards));
  const Vec3 up = cross(towards, right);
  const FittedEye fitted =
      fittedEye(corners(), {right, up, towards, {}}, {aspect * tangent, tangent});
  look(fitted.target, fitted.eye, up);
  m_renderer->GetActiveCamera()->SetViewAngle(fov);
  m_handles.setSceneEye(fitted.eye);
  redraw();
}

void DisplayScene::fit() {
  const double size = std::max(m_display.size[0], m_display.size[1]);
  look(m_display.position, m_display.position + size * Vec3{0.6, 0.5, 2.6}, {0, 1, 0});
  fitDistance();
}

void DisplayScene::lookFrom(SceneSide side) {
  const auto [right, up, front, centre] =
      transformFromPose(m_display.position, m_display.orientation);
  const double far = 2 * std::max(m_display.size[0], m_display.size[1]);
  if (side == SceneSide::front) look(centre, centre + far * front, up);
  if (side == SceneSide::top) look(centre, centre + far * up, -1.0 * front);
  if (side == SceneSide::side) look(centre, centre + far * right, up);
  fitDistance();
}

void DisplayScene::turn(double right, double up) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->Azimuth(right);
  camera->Elevation(up);
  camera->OrthogonalizeViewUp();
  redraw();
}

void DisplayScene::approach(double factor) {
  m_renderer->GetActiveCamera()->Dolly(factor);
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

std::vector<int> DisplayScene::statesAt(int x, int y) const {
  const QSize size = m_widget.deviceSize();
  constexpr double tolerance = 4;  // pixels
  return m_frusta.statesAt(m_renderer, {x + 0.5, y + 0.5, tolerance, size.width(), size.height()});
}

std::optional<Hit> DisplayScene::hogelAt(int x, int y) const {
  if (m_display.hogels[0] < 1 || m_display.directions[0] < 1) return std::nullopt;
  m_renderer->SetDisplayPoint(x + 0.5, y + 0.5, 1);
  m_renderer->DisplayToWorld();
  const double* far = m_renderer->GetWorldPoint();
  const Display display(m_display);
  const Vec3 from = eye().eye;
  const Vec3 to = {far[0] / far[3], far[1] / far[3], far[2] / far[3]};
  const RigidTransform& displayFromWorld = display.displayFromWorld();
  const std::optional<Hit> place =
      display.intersectPlane(displayFromWorld.point(from), displayFromWorld.direction(to - from));
  return place && display.isOnPanel(*place) ? place : std::nullopt;
}

}  // namespace hogelscope
