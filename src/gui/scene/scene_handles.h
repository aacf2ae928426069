// SPDX-License-Identifier: BSD-3-Clause
// Balls in the 3-D scene that are dragged in the plane of the screen to move a camera's eye and
// look-at point or a mesh, and arrows along the world's axes at one of them: the eye's, or the one
// that was touched last. SceneOverlay paints them.
#pragma once

#include <QObject>
#include <QPointF>
#include <array>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

class vtkObject;
class vtkRenderer;
class vtkRenderWindowInteractor;

namespace hogelscope {

/// An arrow on the screen, in pixels from the upper left.
struct AxisArrow {
  int axis = 0;  ///< 0 … 2: x, y, z
  QPointF from;  ///< the ball's middle
  QPointF to;
  bool isHeld = false;  ///< the pointer is on it or drags it
};

/// Returns arrows along the world's axes from a point, `length` metres long, without those that
/// point nearly at the scene's eye.
std::vector<AxisArrow> arrowsAt(vtkRenderer& renderer, const Vec3& from, double length);

enum class SceneBall { eye, lookat, mesh };

class SceneHandles : public QObject {
  Q_OBJECT

 public:
  SceneHandles(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, QObject* parent);
  ~SceneHandles() override;

  /// Puts a ball at a point of the world, in metres; nullopt hides it.
  void show(SceneBall ball, const std::optional<Vec3>& place) {
    m_places[std::size_t(ball)] = place;
  }
  /// Returns where a ball is on the screen; none if it is hidden, or so near to the scene's eye
  /// that it would be in the way.
  [[nodiscard]] std::optional<QPointF> ballAt(SceneBall ball) const;
  /// Returns the arrows at the ball that was touched last, at first the eye's.
  [[nodiscard]] std::vector<AxisArrow> arrows() const;

 Q_SIGNALS:
  void dragged(hogelscope::SceneBall ball, const hogelscope::Vec3& place);
  /// The arrows are at another ball, or another one is held.
  void arrowsChanged();

 private:
  bool onPress(vtkObject* caller, unsigned long event, void* data);
  bool onMove(vtkObject* caller, unsigned long event, void* data);
  bool onRelease(vtkObject* caller, unsigned long event, void* data);
  [[nodiscard]] QPointF pointer() const;
  [[nodiscard]] double alongAxis() const;
  void touch(const QPointF& at);

  static constexpr int none = -1, wholeBall = 3;
  vtkRenderer* m_renderer;
  vtkRenderWindowInteractor* m_interactor;
  std::array<unsigned long, 3> m_observers{};  ///< of the interactor
  std::array<std::optional<Vec3>, 3> m_places;
  SceneBall m_touched = SceneBall::eye;  ///< has the arrows
  int m_held = none;                     ///< the ball itself, or an arrow's axis
  bool m_isDragging = false;
  Vec3 m_start;        ///< of the drag: the ball's place
  QPointF m_grabbed;   ///< there the pointer was pressed
  double m_along = 0;  ///< the same in metres along the axis
};

}  // namespace hogelscope
