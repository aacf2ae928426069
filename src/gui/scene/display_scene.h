// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene: the panel, the frusta of all states and the picked objects; its own camera, the
// scene's eye; picking under the pointer.
// It is fitted to the corners of panel, frusta, mesh and the viewing zone's outline (fittedEye),
// not to a sphere around them. Only the zone's body is translucent, and off at first: VTK's pass
// for that goes over the whole picture.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <QObject>
#include <vector>

#include "core/optics/session.h"
#include "gui/scene/frustum_actors.h"
#include "gui/scene/mesh_actors.h"
#include "gui/scene/panel_actors.h"
#include "gui/scene/pick_actors.h"
#include "gui/scene/scene_handles.h"
#include "gui/scene/twin_actors.h"
#include "gui/widgets/colours.h"

class QPainter;
class QTimer;
class vtkRenderer;

namespace hogelscope {

class VtkWidget;

/// The viewing direction along the panel's axes.
enum class SceneSide { front, back, top, bottom, right, left };

class DisplayScene : public QObject {
  Q_OBJECT

 public:
  DisplayScene(VtkWidget& widget, QObject* parent);
  ~DisplayScene() override;

  /// Sets the colours of all parts; `background` may be transparent.
  void setColours(const Tokens& colours, const QColor& background);
  /// Shows display and states. `display` has resolved hogel counts. States without a camera frame
  /// are skipped.
  void show(const PanelParams& display, const std::vector<CameraState>& states,
            std::size_t current);
  /// Shows the planes between which content is sharp for the current eye.
  void setDepthsVisible(bool isVisible) { m_hasDepths = isVisible; }
  void setScaleBarVisible(bool isVisible) { m_hasScaleBar = isVisible; }
  /// Shows the world's axes at its origin.
  void setAxesVisible(bool areVisible) { m_hasAxes = areVisible; }
  /// Up to two points of the world, shown with the distance between them.
  [[nodiscard]] std::vector<Vec3>& measured() { return m_measured; }
  /// Paints scale bar, legend and axes over a picture of the scene, in the widget's pixels; the
  /// handles' arrows, too, if wanted.
  void paintOver(QPainter& painter, bool hasArrows) const;
  [[nodiscard]] FrustumActors& frusta() { return m_frusta; }
  [[nodiscard]] PanelActors& panel() { return m_panel; }
  [[nodiscard]] MeshActors& mesh() { return m_mesh; }
  [[nodiscard]] ZoneActors& zone() { return m_zone; }
  [[nodiscard]] TwinActors& twin() { return m_twin; }
  [[nodiscard]] PickActors& picked() { return m_picked; }
  [[nodiscard]] SceneHandles& handles() { return m_handles; }
  [[nodiscard]] vtkRenderer* renderer() const { return m_renderer; }
  /// Redraws the scene if any of its parts has changed.
  void redraw();

  /// Views everything from the front, from the left and above.
  void reset();
  /// Moves the eye along its direction until everything fits the window. If it is there already,
  /// calls reset().
  void fit();
  /// Fits what has changed, window or scene, if the eye has not been moved since the last fit.
  void keepFitted();
  void lookFrom(SceneSide side);
  /// Switches between parallel and perspective projection.
  void setParallel(bool isParallel);
  /// Rotates the eye around the scene's focal point, to the right and upwards, in degrees.
  void turn(double right, double up);
  /// Divides the eye's distance, or the height of a parallel projection, by `factor`.
  void approach(double factor);
  /// Takes the state's pose and vertical field of view. A state without a camera frame is ignored.
  void lookThrough(const CameraState& state);
  /// Returns the scene's eye: only eye, lookat, up and fov are set. Metres, degrees.
  [[nodiscard]] CameraParams eye() const;
  /// Returns the point from which the panel is seen: the eye or, in a parallel projection, a point
  /// so distant that its rays are parallel to within 1e-4.
  [[nodiscard]] Vec3 viewpoint() const;

  /// Returns the size in metres of a screen pixel on the panel, at the panel's nearest point.
  [[nodiscard]] double pixelOnPanel() const;

  /// Returns the states at a pixel, in ascending order. Pixels count from the lower left.
  [[nodiscard]] std::vector<int> statesAt(int x, int y) const;
  /// Returns the point of the world under a pixel: an eye, the look-at point or a corner of the
  /// panel if one is near, otherwise the nearest of panel and mesh.
  [[nodiscard]] std::optional<Vec3> pointAt(int x, int y) const;
  /// Returns the hogel under a pixel, in real-valued indices, whether it emits light here or not.
  [[nodiscard]] std::optional<Hit> hogelAt(int x, int y) const;

 Q_SIGNALS:
  /// The scene's eye or the window has changed; emitted once for many changes.
  void eyeChanged();

 private:
  [[nodiscard]] vtkMTimeType changedAt() const;
  void adjustToEye();
  [[nodiscard]] std::vector<Vec3> panelCorners() const;
  [[nodiscard]] std::vector<Vec3> corners() const;
  void fitDistance();
  void look(const Vec3& target, const Vec3& from, const Vec3& up);

  VtkWidget& m_widget;
  vtkNew<vtkRenderer> m_renderer;
  PanelActors m_panel;
  FrustumActors m_frusta;
  MeshActors m_mesh;
  ZoneActors m_zone;
  TwinActors m_twin;
  PickActors m_picked;
  SceneHandles m_handles;
  QTimer* m_eyeTimer;
  const Tokens* m_colours = &tokens();
  QColor m_background;
  std::size_t m_current = 0;  ///< state
  std::vector<Vec3> m_marks;  ///< panel corners, eyes, the current look-at point
  /// Outlines at the current eye's depth, or of a sheet's cones at its viewing distance.
  std::vector<Vec3> m_wholeZone, m_someZone;
  std::vector<std::vector<Vec3>> m_depths;  ///< corners of the planes of sharp depths
  bool m_hasDepths = false;
  std::vector<Vec3> m_measured;  ///< up to two points
  bool m_hasScaleBar = true;
  bool m_hasAxes = false;
  std::optional<CameraParams> m_fitted;  ///< the eye that fit() or lookFrom() chose last
  PanelParams m_display;
  vtkMTimeType m_drawnAt = 0;  ///< changedAt() of the last requested drawing
};

}  // namespace hogelscope
