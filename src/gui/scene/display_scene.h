// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene: the panel, the frusta of all states, what is picked; its own camera, the scene's
// eye; what lies under the pointer.
#pragma once

#include <vtkNew.h>
#include <vtkType.h>

#include <QObject>
#include <vector>

#include "core/optics/session.h"
#include "gui/scene/frustum_actors.h"
#include "gui/scene/mesh_actors.h"
#include "gui/scene/panel_actors.h"
#include "gui/scene/pick_actors.h"
#include "gui/scene/scene_handles.h"
#include "gui/scene/zone_actors.h"

class QTimer;
class vtkAxesActor;
class vtkOrientationMarkerWidget;
class vtkRenderer;

namespace hogelscope {

class VtkWidget;

/// Along the panel's axes.
enum class SceneSide { front, back, top, bottom, right, left };

class DisplayScene : public QObject {
  Q_OBJECT

 public:
  DisplayScene(VtkWidget& widget, QObject* parent);
  ~DisplayScene() override;

  /// `display` has its hogels resolved. States without a camera frame are left out.
  void show(const DisplayParams& display, const std::vector<CameraState>& states,
            std::size_t current);
  [[nodiscard]] FrustumActors& frusta() { return m_frusta; }
  [[nodiscard]] PanelActors& panel() { return m_panel; }
  [[nodiscard]] MeshActors& mesh() { return m_mesh; }
  [[nodiscard]] ZoneActors& zone() { return m_zone; }
  [[nodiscard]] PickActors& picked() { return m_picked; }
  [[nodiscard]] SceneHandles& handles() { return m_handles; }
  [[nodiscard]] vtkRenderer* renderer() const { return m_renderer; }
  /// After a change of its parts; draws nothing where there was none.
  void redraw();

  /// Looks at all of it from the front, a little from the right and above.
  void reset();
  /// Goes where all of it fills the window, in the direction that the eye has; where it is there
  /// already, reset().
  void fit();
  void lookFrom(SceneSide side);
  /// Lengths across the view are the same at any distance.
  void setParallel(bool isParallel);
  /// The eye goes round what the scene looks at, to the right and upwards; degrees.
  void turn(double right, double up);
  /// So many times nearer.
  void approach(double factor);
  /// With the state's pose and vertical field of view. A state without a frame changes nothing.
  void lookThrough(const CameraState& state);
  /// The scene's eye; eye, lookat, up and fov only. Metres, degrees.
  [[nodiscard]] CameraParams eye() const;
  /// The point that the panel is seen from: the eye or, in a parallel projection, one so far away
  /// that its rays are parallel to a ten thousandth.
  [[nodiscard]] Vec3 viewpoint() const;

  /// How large a pixel of the screen is on the panel, where that is nearest, in metres.
  [[nodiscard]] double pixelOnPanel() const;

  /// Pixels from the lower left. States in ascending order.
  [[nodiscard]] std::vector<int> statesAt(int x, int y) const;
  /// The hogel under a pixel; in real-valued indices, whether it sends light here or not.
  [[nodiscard]] std::optional<Hit> hogelAt(int x, int y) const;

 Q_SIGNALS:
  /// The scene's eye or its window is another one; once for many changes.
  void eyeChanged();

 private:
  [[nodiscard]] vtkMTimeType changedAt() const;
  void adjustToEye();
  void adjustToWindow();
  [[nodiscard]] std::vector<Vec3> corners() const;
  void fitDistance();
  void look(const Vec3& target, const Vec3& from, const Vec3& up);

  VtkWidget& m_widget;
  vtkNew<vtkRenderer> m_renderer;
  PanelActors m_panel;
  FrustumActors m_frusta;
  MeshActors m_mesh;
  ZoneActors m_zone;
  PickActors m_picked;
  SceneHandles m_handles;
  vtkNew<vtkAxesActor> m_axes;
  vtkNew<vtkOrientationMarkerWidget> m_marker;
  QTimer* m_eyeTimer;
  std::optional<CameraParams> m_fitted;  ///< the eye that fit() or lookFrom() chose last
  DisplayParams m_display;
  vtkMTimeType m_drawnAt = 0;  ///< changedAt() of what was last asked to be drawn
};

}  // namespace hogelscope
