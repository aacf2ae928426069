// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_handles.h"

#include <vtkActor.h>
#include <vtkCommand.h>
#include <vtkHandleWidget.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereHandleRepresentation.h>

#include "gui/scene/scene_actor.h"

namespace hogelscope {

namespace {

Vec3 positionOf(vtkSphereHandleRepresentation* ball) {
  double p[3];
  ball->GetWorldPosition(p);
  return {p[0], p[1], p[2]};
}

void move(vtkSphereHandleRepresentation* ball, const Vec3& to) {
  double p[3] = {to.x, to.y, to.z};
  ball->SetWorldPosition(p);
}

}  // namespace

SceneHandles::SceneHandles(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor,
                           QObject* parent)
    : QObject(parent), m_renderer(renderer), m_interactor(interactor) {
  setUp(m_eye, {1.00, 0.65, 0.15});
  setUp(m_lookat, {0.95, 0.90, 0.75});
  setUp(m_mesh, {0.45, 0.85, 0.45});
}

SceneHandles::~SceneHandles() {
  for (Handle* handle : {&m_eye, &m_lookat, &m_mesh}) {
    handle->widget->RemoveAllObservers();
    handle->widget->SetInteractor(nullptr);
  }
}

void SceneHandles::setUp(Handle& handle, const std::array<double, 3>& colour) {
  handle.ball->SetHandleSize(12);  // pixels
  handle.ball->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  handle.ball->GetSelectedProperty()->SetColor(1, 1, 1);
  const vtkNew<vtkPropCollection> parts;
  handle.ball->GetActors(parts);
  setDepth(vtkActor::SafeDownCast(parts->GetItemAsObject(0)), SceneLevel::handle);
  handle.widget->SetRepresentation(handle.ball);
  handle.widget->SetInteractor(m_interactor);
  handle.widget->SetDefaultRenderer(m_renderer);
  handle.widget->ManagesCursorOff();
  handle.widget->AllowHandleResizeOff();
  handle.widget->AddObserver(vtkCommand::InteractionEvent, this, &SceneHandles::onDrag);
}

void SceneHandles::onDrag(vtkObject* widget, unsigned long, void*) {
  if (widget == m_eye.widget.Get()) Q_EMIT eyeDragged(positionOf(m_eye.ball));
  if (widget == m_lookat.widget.Get()) Q_EMIT lookatDragged(positionOf(m_lookat.ball));
  if (widget == m_mesh.widget.Get()) Q_EMIT meshDragged(positionOf(m_mesh.ball));
}

void SceneHandles::showAt(const Vec3& eye, const Vec3& lookat) {
  if (m_eye.isPlaced && positionOf(m_eye.ball) == eye && positionOf(m_lookat.ball) == lookat)
    return;
  move(m_eye.ball, eye);
  move(m_lookat.ball, lookat);
  m_eye.isPlaced = m_lookat.isPlaced = true;
  update();
}

void SceneHandles::showMeshAt(const std::optional<Vec3>& place) {
  if (m_mesh.isPlaced == place.has_value() && (!place || positionOf(m_mesh.ball) == *place)) return;
  m_mesh.isPlaced = place.has_value();
  if (place) move(m_mesh.ball, *place);
  update();
}

void SceneHandles::hide() {
  m_eye.isPlaced = m_lookat.isPlaced = false;
  update();
}

void SceneHandles::setSceneEye(const Vec3& sceneEye) {
  m_sceneEye = sceneEye;
  update();
}

void SceneHandles::update() {
  const double near = 0.05 * length(positionOf(m_eye.ball) - positionOf(m_lookat.ball));
  for (Handle* handle : {&m_eye, &m_lookat, &m_mesh}) {
    const bool isShown = handle->isPlaced && length(positionOf(handle->ball) - m_sceneEye) > near;
    handle->ball->Modified();  // keeps the size in pixels instead of metres
    if ((handle->widget->GetEnabled() != 0) != isShown) handle->widget->SetEnabled(isShown);
    if (isShown) handle->ball->BuildRepresentation();  // for its bounds, used by fitting
  }
}

}  // namespace hogelscope
