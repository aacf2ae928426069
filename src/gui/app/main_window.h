// SPDX-License-Identifier: BSD-3-Clause
// The main window: connects scene, simulated view, docks and menus. It contains no logic of its
// own.
#pragma once

#include <QMainWindow>
#include <memory>

#include "core/optics/session.h"
#include "gui/view/picture_rate.h"
#include "io/scene/scene.h"
#include "study/tradeoff.h"

class QComboBox;
class QTimer;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class DistortionDock;
class FileCommands;
class HomePage;
class LightFieldDock;
class Messages;
class ImageCommands;
class PsfDock;
class ReadingBar;
class SceneController;
class SessionModel;
class ViewWorker;
class WindowLayout;
struct RenderedView;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Restores the window's layout, offers the recovery of sessions after a crash, and opens `files`
  /// (FileCommands::openFiles).
  void start(const QStringList& files);

 private:
  void connectActions();
  void connectModel();
  void addDocks();
  void arrangeDocks();
  void connectDocks();
  void connectWorker();
  void addEditing();
  void addHabits();
  void closeEvent(QCloseEvent* event) override;
  void leaveForm();
  void showFailure(const QString& line);
  void showStopped();
  void showSession();
  void showContent();
  void load();
  void loadWhatWaits();
  void forgetScene();
  void endReading();
  void showReading();
  void showScene();
  void onSceneLoaded(const Scene& scene);
  void showCurrent();
  void showTitle();
  void render();
  void showView(const RenderedView& view);
  void offerViews();
  void showStates();

  std::unique_ptr<Ui::MainWindow> m_ui;
  SessionModel* m_model;
  ViewWorker* m_worker;
  Messages* m_messages = nullptr;
  HomePage* m_home = nullptr;
  FileCommands* m_files = nullptr;
  WindowLayout* m_layout = nullptr;
  ReadingBar* m_readingBar = nullptr;
  QTimer* m_sayReading = nullptr;
  QComboBox* m_stateBox;
  SceneController* m_scene;
  ImageCommands* m_imageCommands = nullptr;
  DistortionDock* m_distortion = nullptr;
  LightFieldDock* m_lightField = nullptr;
  PsfDock* m_psf = nullptr;
  PictureRate m_rate;
  DisplayParams m_display;        ///< resolved
  bool m_isNew = false;           ///< the session is new, so the scene has to be fitted to it
  std::optional<Scene> m_loaded;  ///< none while a light field is read, or if it cannot be read
  Session m_asked;                ///< the session whose light field is being read or was read last
  bool m_isReading = false;  ///< m_asked is being read; m_loaded is an older light field, if any
  bool m_isAwaited = false;  ///< the first image of m_asked has not been rendered yet
  std::optional<NamedMethod> m_method;  ///< of the live view; none: the session's own
};

}  // namespace hogelscope
