// SPDX-License-Identifier: BSD-3-Clause
// Connects the 3-D scene with the session, its rendering thread and the Scene menu.
// Others speak to the scene through this class alone.
#pragma once

#include <QObject>
#include <QPoint>
#include <QRegion>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "gui/scene/scene_worker.h"
#include "gui/widgets/task.h"
#include "io/scene/view_source.h"
#include "picture/stereo_view.h"

class QAction;
class QLabel;
class QMenu;

namespace hogelscope {

class DisplayScene;
class SessionModel;
class VtkWidget;

class SceneController : public QObject {
  Q_OBJECT

 public:
  /// `readout` shows a description of what is picked in `widget`.
  SceneController(QMenu* menu, VtkWidget* widget, QLabel* readout, SessionModel* model,
                  QObject* parent);
  ~SceneController() override;

  /// Sets the session's light field with its display; none while it is read.
  void setSource(const std::optional<ViewSource>& scene);
  /// Colours the frusta by the states' PSNR in dB; empty: no colours. Infinite: identical; NaN: no
  /// view.
  void showPsnr(const std::vector<double>& dB);
  /// Renders the images of these states whenever they have changed and nothing has been edited for
  /// a moment; stateRendered() follows. Empty: none.
  void watchStates(const std::vector<std::size_t>& states);
  /// Shows states that are not in the session yet; empty: none.
  void showPreview(const std::vector<CameraState>& states);
  /// Picks a pixel of the current state's simulated view, and shows its ray and where the ray ends.
  /// A pixel outside the image removes the pick.
  void showPixel(int x, int y);
  /// Whether the panel shows what is seen.
  [[nodiscard]] bool showsPanelImage() const;
  [[nodiscard]] VtkWidget* widget() const { return m_widget; }
  [[nodiscard]] DisplayScene& scene() const { return *m_scene; }
  /// Renders the panel again as the scene's eye sees it.
  void renderPanel();

  /// Sets which eyes of a state with two the simulated view shows.
  void setEyes(StereoView eyes);

  /// Returns the current state's rendering job; none without a light field or a state.
  [[nodiscard]] std::optional<RenderJob> job() const;
  /// Returns the view of the eye that a pixel of the simulated view belongs to, and the pixel
  /// there; none without a light field or a state, or outside the image.
  [[nodiscard]] std::optional<PickedView> viewAt(const QPoint& pixel) const;
  /// Returns the number of views of the session's quilt; 0 for other light fields.
  [[nodiscard]] int views() const;
  [[nodiscard]] const std::optional<QPoint>& pickedPixel() const { return m_pixel; }
  /// The hogel picked in the scene.
  [[nodiscard]] const std::optional<QPoint>& pickedHogel() const { return m_hogel; }

 Q_SIGNALS:
  /// The pick or its description has changed.
  void pickChanged();
  /// A small image of a state's view, its rows from below.
  void stateRendered(int index, const hogelscope::VtkImage& image);
  /// The picked pixel, or the pixels that see the picked hogel; empty: none.
  void pixelsMarked(const QRegion& pixels);

 private:
  void addCommands(QMenu* menu);
  void addSides(QMenu* menu);
  void addTurns(QMenu* menu);
  void addParts(QMenu* menu);
  void connectModel();
  void connectScene();
  void refresh();
  void showModel();
  void showMesh();
  void moveMesh(const Vec3& ball);
  [[nodiscard]] Vec3 toMeshBall() const;
  void forgetPicks();
  void removePicks();
  void addTools(QMenu* menu);
  void setMeasuring(bool isOn);
  void measureAt(int x, int y);
  void pickAt(int x, int y);
  void nameAt(int x, int y);
  void showHogel(int i, int j);
  void markHogel();
  void tracePixel();
  void showText();
  void renderStates();
  void requestStates();
  void setStateFromScene();

  VtkWidget* m_widget;
  QLabel* m_readout;
  SessionModel* m_model;
  SceneWorker* m_worker;
  QAction *m_parallel = nullptr, *m_forget = nullptr;
  QAction *m_panelImage = nullptr, *m_stateImages = nullptr, *m_showsMesh = nullptr;
  QAction* m_measures = nullptr;
  std::unique_ptr<DisplayScene> m_scene;
  PanelParams m_display;               ///< resolved once the light field has been read
  std::optional<ViewSource> m_loaded;  ///< none while a light field is read
  std::optional<QPoint> m_pixel;       ///< picked in the current state's view
  std::optional<QPoint> m_hogel;
  StereoView m_eyes = StereoView::head;
  QString m_pickText;
  bool m_isPanelDark = false;  ///< no light reaches the scene's eye, so the grid marks the panel
  std::vector<std::size_t> m_watched;  ///< states whose images the list shows
  bool m_isPanelOld = false;           ///< its picture is to be made when edits rest
  QTimer m_stateDelay;                 ///< until the pictures of states, and of the panel, are made
  Task m_pixelSearch;                  ///< finds the pixels that see the hogel
};

}  // namespace hogelscope
