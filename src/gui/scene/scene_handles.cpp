// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_handles.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QLineF>
#include <algorithm>
#include <utility>

#include "core/optics/scene_eyes.h"
#include "gui/scene/scene_actor.h"

namespace hogelscope {

namespace {

constexpr std::array<Vec3, 3> worldAxes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

}  // namespace

std::vector<AxisArrow> arrowsAt(vtkRenderer& renderer, const Vec3& from, double length) {
  constexpr double shortest = 20;  // pixels
  std::vector<AxisArrow> all;
  const std::optional<QPointF> start = onScreen(renderer, from);
  for (int axis = 0; axis < 3; ++axis) {
    const auto end = onScreen(renderer, from + length * worldAxes[std::size_t(axis)]);
    if (start && end && QLineF(*start, *end).length() >= shortest)
      all.push_back({axis, *start, *end});
  }
  return all;
}

SceneHandles::SceneHandles(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor,
                           QObject* parent)
    : QObject(parent), m_renderer(renderer), m_interactor(interactor) {
  // Before the scene turns.
  m_observers = {
      interactor->AddObserver(vtkCommand::LeftButtonPressEvent, this, &SceneHandles::onPress, 1),
      interactor->AddObserver(vtkCommand::MouseMoveEvent, this, &SceneHandles::onMove, 1),
      interactor->AddObserver(vtkCommand::LeftButtonReleaseEvent, this, &SceneHandles::onRelease,
                              1)};
}

SceneHandles::~SceneHandles() {
  for (const unsigned long observer : m_observers) m_interactor->RemoveObserver(observer);
}

QPointF SceneHandles::pointer() const {
  const int* at = m_interactor->GetEventPosition();
  return {at[0] + 0.5, m_renderer->GetSize()[1] - at[1] - 0.5};
}

std::optional<QPointF> SceneHandles::ballAt(SceneBall ball) const {
  const auto& [eye, lookat, mesh] = m_places;
  const std::optional<Vec3>& place = m_places[std::size_t(ball)];
  if (!place) return std::nullopt;
  const double* p = m_renderer->GetActiveCamera()->GetPosition();
  const double near = eye && lookat ? 0.05 * length(*eye - *lookat) : 0;
  if (length(*place - Vec3{p[0], p[1], p[2]}) <= near) return std::nullopt;
  return onScreen(*m_renderer, *place);
}

std::vector<AxisArrow> SceneHandles::arrows() const {
  if (!ballAt(m_touched)) return {};
  constexpr double pixels = 56;
  const Vec3& from = *m_places[std::size_t(m_touched)];
  std::vector<AxisArrow> all = arrowsAt(*m_renderer, from, pixels * pixelSizeAt(*m_renderer, from));
  for (AxisArrow& arrow : all) arrow.isHeld = arrow.axis == m_held;
  return all;
}

/// Returns how far along the held arrow's axis the pointer is from the drag's start, in metres.
double SceneHandles::alongAxis() const {
  const auto [near, far] = lineAt(*m_renderer, pointer());
  return nearestOnLine(m_start, worldAxes[std::size_t(m_held)], near, far - near);
}

/// Holds the ball or the arrow at a place on the screen.
void SceneHandles::touch(const QPointF& at) {
  constexpr double tolerance = 7;  // pixels
  const std::pair before(m_touched, std::exchange(m_held, none));
  for (const AxisArrow& arrow : arrows()) {
    const QPointF way = arrow.to - arrow.from;
    const double along = QPointF::dotProduct(at - arrow.from, way) / QPointF::dotProduct(way, way);
    const QPointF nearest = arrow.from + std::clamp(along, 0.0, 1.1) * way;
    if (QLineF(nearest, at).length() <= tolerance) m_held = arrow.axis;
  }
  for (const SceneBall ball : {SceneBall::mesh, SceneBall::lookat, SceneBall::eye}) {
    const std::optional<QPointF> place = ballAt(ball);
    if (!place || QLineF(*place, at).length() > tolerance) continue;
    m_touched = ball;
    m_held = wholeBall;
  }
  if (std::pair(m_touched, m_held) != before) Q_EMIT arrowsChanged();
}

bool SceneHandles::onPress(vtkObject*, unsigned long, void*) {
  touch(pointer());
  m_isDragging = m_held != none;
  if (!m_isDragging) return false;
  m_start = *m_places[std::size_t(m_touched)];
  m_grabbed = pointer();
  if (m_held != wholeBall) m_along = alongAxis();
  return true;  // nobody else hears of it
}

bool SceneHandles::onMove(vtkObject*, unsigned long, void*) {
  if (!m_isDragging) {
    touch(pointer());
    return false;
  }
  const QPointF way = pixelSizeAt(*m_renderer, m_start) * (pointer() - m_grabbed);
  const RigidTransform eyeFromWorld = viewOf(*m_renderer);
  const Vec3 place = m_held == wholeBall
                         ? m_start + eyeFromWorld.inverse().direction({way.x(), -way.y(), 0})
                         : m_start + (alongAxis() - m_along) * worldAxes[std::size_t(m_held)];
  Q_EMIT dragged(m_touched, place);
  return true;
}

bool SceneHandles::onRelease(vtkObject*, unsigned long, void*) {
  return std::exchange(m_isDragging, false);
}

}  // namespace hogelscope
