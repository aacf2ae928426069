// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene: the panel, the frusta of all states, what is picked; its own camera, the scene's
// eye; what lies under the pointer.
#pragma once

#include <vtkNew.h>

#include <QObject>
#include <vector>

#include "core/optics/session.h"
#include "gui/scene/frustum_actors.h"
#include "gui/scene/mesh_actors.h"
#include "gui/scene/panel_actors.h"
#include "gui/scene/pick_actors.h"
#include "gui/scene/scene_handles.h"

class QTimer;
class vtkAxesActor;
class vtkOrientationMarkerWidget;
class vtkRenderer;

namespace hogelscope {

class VtkWidget;

/// Along the panel's axes: from its front, from above, from its right.
enum class SceneSide { front, top, side };

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
  [[nodiscard]] PickActors& picked() { return m_picked; }
  [[nodiscard]] SceneHandles& handles() { return m_handles; }
  [[nodiscard]] vtkRenderer* renderer() const { return m_renderer; }
  /// After a change of its parts.
  void redraw();

  /// Looks at all of it from the front, a little from the right and above.
  void fit();
  void lookFrom(SceneSide side);
  /// The eye goes round what the scene looks at, to the right and upwards; degrees.
  void turn(double right, double up);
  /// So many times nearer.
  void approach(double factor);
  /// With the state's pose and vertical field of view. A state without a frame changes nothing.
  void lookThrough(const CameraState& state);
  /// The scene's eye; eye, lookat, up and fov only. Metres, degrees.
  [[nodiscard]] CameraParams eye() const;

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
  void adjustToEye();
  [[nodiscard]] std::vector<Vec3> corners() const;
  void fitDistance();
  void look(const Vec3& target, const Vec3& from, const Vec3& up);

  VtkWidget& m_widget;
  vtkNew<vtkRenderer> m_renderer;
  PanelActors m_panel;
  FrustumActors m_frusta;
  MeshActors m_mesh;
  PickActors m_picked;
  SceneHandles m_handles;
  vtkNew<vtkAxesActor> m_axes;
  vtkNew<vtkOrientationMarkerWidget> m_marker;
  QTimer* m_eyeTimer;
  DisplayParams m_display;
};

}  // namespace hogelscope
