// SPDX-License-Identifier: BSD-3-Clause
// Joins the 3-D scene with the session, its rendering thread and the Scene menu.
#pragma once

#include <QObject>
#include <QPoint>
#include <memory>
#include <optional>
#include <vector>

#include "gui/scene/scene_worker.h"
#include "gui/widgets/task.h"
#include "io/scene/scene.h"

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class DisplayScene;
class SessionModel;

class SceneController : public QObject {
  Q_OBJECT

 public:
  /// Takes the scene's widget, its read-out and its actions from the form.
  SceneController(const Ui::MainWindow& form, SessionModel* model, QObject* parent);
  ~SceneController() override;

  /// The session's light field, with its display; none while it is read.
  void setScene(const std::optional<Scene>& scene);
  /// Colours the frusta, by state, in dB; empty: no longer. Infinite is identical, NaN no view.
  void showPsnr(const std::vector<double>& dB);
  /// States that are not in the session yet, beside its own; empty: none.
  void showPreview(const std::vector<CameraState>& states);
  /// A pixel of the current state's simulated view: its ray and what that meets. A pixel outside
  /// the image ends that.
  void showPixel(int x, int y);
  [[nodiscard]] DisplayScene& scene() const { return *m_scene; }
  /// Anew, as the scene's eye sees it on the screen.
  void renderPanel();

  /// The current state's view of what has been read; none without either.
  [[nodiscard]] std::optional<RenderJob> job() const;
  [[nodiscard]] const std::optional<QPoint>& pickedPixel() const { return m_pixel; }
  /// That was clicked in the scene.
  [[nodiscard]] const std::optional<QPoint>& pickedHogel() const { return m_hogel; }

 Q_SIGNALS:
  /// What is picked, or what is said of it.
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
  DisplayParams m_display;        ///< as far as it is known
  std::optional<Scene> m_loaded;  ///< none while a light field is read
  std::optional<QPoint> m_pixel;  ///< picked, of the current state's view
  std::optional<QPoint> m_hogel;
  QString m_pickText;
  bool m_isPanelDark = false;  ///< no light reaches the scene's eye: the grid shows where it is
  Task m_seers;                ///< finds the pixels that see the hogel
};

}  // namespace hogelscope
