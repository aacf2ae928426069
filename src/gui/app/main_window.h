// SPDX-License-Identifier: BSD-3-Clause
// The main window: connects scene, simulated view, docks and menus. It contains no logic of its
// own.
#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>
#include <vector>

#include "gui/view/picture_rate.h"
#include "study/tradeoff.h"

class QComboBox;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class CameraPlayer;
class ContentLoader;
class ContentOptimiser;
class FrameBar;
class FrameStream;
class FileCommands;
class Guide;
class HomePage;
class LightFieldOutput;
class Messages;
class ImageCommands;
class Properties;
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
  void connectDocks();
  void connectMeasuring();
  void fillToolBar();
  void addTopBar();
  void connectWorker();
  void connectLoader();
  void connectFrames();
  void addEditing();
  void addHelpers();
  void closeEvent(QCloseEvent* event) override;
  void leaveForm();
  void showFailure(const QString& line);
  void addProgress();
  void showLooking(const QString& line);
  void showSession();
  void showContent();
  void showScene();
  void showCurrent();
  void showTitle();
  void render();
  void showView(const RenderedView& view);
  void forgetMeasurement();
  [[nodiscard]] std::vector<RenderJob> views() const;
  void showStates();

  std::unique_ptr<Ui::MainWindow> m_ui;
  SessionModel* m_model;
  ViewWorker* m_worker;
  ContentLoader* m_loader = nullptr;
  Messages* m_messages = nullptr;
  HomePage* m_home = nullptr;
  FileCommands* m_files = nullptr;
  LightFieldOutput* m_lightFieldOutput = nullptr;
  ContentOptimiser* m_optimiser = nullptr;
  WindowLayout* m_layout = nullptr;
  ReadingBar *m_readingBar = nullptr, *m_lookingBar = nullptr;
  QString m_noticeBefore;
  QString m_lookingLine;  ///< on the picture while a light field is looked at
  QComboBox* m_stateBox;
  QAction* m_undoToPicture;  ///< undoes what was edited since a picture was right
  int m_askedAt = 0;         ///< edits that could be undone when the last view was asked for
  int m_shownAt = 0;         ///< the same of the last view that was shown
  Guide* m_guide = nullptr;
  QMenu *m_colours, *m_textSizes;
  SceneController* m_scene;
  ImageCommands* m_imageCommands = nullptr;
  CameraPlayer* m_player = nullptr;
  FrameStream* m_frames = nullptr;
  FrameBar* m_frameBar = nullptr;
  Properties* m_properties = nullptr;
  PictureRate m_rate;
  bool m_isNew = false;                 ///< the session is new, so the scene has to be fitted to it
  std::optional<NamedMethod> m_method;  ///< of the live view; none: the session's own
};

}  // namespace hogelscope
