// SPDX-License-Identifier: BSD-3-Clause
// Connects the 3-D scene with the session, its rendering thread and the Scene menu.
// Others speak to the scene through this class alone.
#pragma once

#include <QObject>
#include <QPoint>
#include <memory>
#include <optional>
#include <vector>

#include "gui/scene/scene_worker.h"
#include "gui/widgets/task.h"
#include "io/scene/view_source.h"

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class DisplayScene;
class SessionModel;

class SceneController : public QObject {
  Q_OBJECT

 public:
  /// Takes the scene's widget, read-out and actions from the form.
  SceneController(const Ui::MainWindow& form, SessionModel* model, QObject* parent);
  ~SceneController() override;

  /// Sets the session's light field with its display; none while it is read.
  void setSource(const std::optional<ViewSource>& scene);
  /// Colours the frusta by the states' PSNR in dB; empty: no colours. Infinite: identical; NaN: no
  /// view.
  void showPsnr(const std::vector<double>& dB);
  /// Shows states that are not in the session yet; empty: none.
  void showPreview(const std::vector<CameraState>& states);
  /// Picks a pixel of the current state's simulated view, and shows its ray and where the ray ends.
  /// A pixel outside the image removes the pick.
  void showPixel(int x, int y);
  [[nodiscard]] DisplayScene& scene() const { return *m_scene; }
  /// Renders the panel again as the scene's eye sees it.
  void renderPanel();

  /// Returns the current state's rendering job; none without a light field or a state.
  [[nodiscard]] std::optional<RenderJob> job() const;
  [[nodiscard]] const std::optional<QPoint>& pickedPixel() const { return m_pixel; }
  /// The hogel picked in the scene.
  [[nodiscard]] const std::optional<QPoint>& pickedHogel() const { return m_hogel; }

 Q_SIGNALS:
  /// The pick or its description has changed.
  void pickChanged();

 private:
  void connectActions();
  void connectModel();
  void connectScene();
  void refresh();
  void showMesh();
  void moveMesh(const Vec3& ball);
  [[nodiscard]] Vec3 toMeshBall() const;
  [[nodiscard]] Vec3 rounded(const Vec3& place) const;
  void forgetPicks();
  void removePicks();
  void pickAt(int x, int y);
  void nameAt(int x, int y);
  void showHogel(int i, int j);
  void markHogel();
  void tracePixel();
  void showText();
  void renderStates();
  void setStateFromScene();

  const Ui::MainWindow& m_form;
  SessionModel* m_model;
  SceneWorker* m_worker;
  std::unique_ptr<DisplayScene> m_scene;
  PanelParams m_display;               ///< resolved once the light field has been read
  std::optional<ViewSource> m_loaded;  ///< none while a light field is read
  std::optional<QPoint> m_pixel;       ///< picked in the current state's view
  std::optional<QPoint> m_hogel;
  QString m_pickText;
  bool m_isPanelDark = false;  ///< no light reaches the scene's eye, so the grid marks the panel
  Task m_pixelSearch;          ///< finds the pixels that see the hogel
};

}  // namespace hogelscope
