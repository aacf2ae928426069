// SPDX-License-Identifier: BSD-3-Clause
// The main window: puts scene, simulated view, docks and menus together. It decides nothing.
#pragma once

#include <QMainWindow>
#include <memory>

#include "core/session.h"
#include "io/light_field_file.h"
#include "study/tradeoff.h"

class QComboBox;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class DisplayScene;
class DistortionDock;
class LightFieldDock;
class PictureCommands;
class SessionModel;
class ViewWorker;
struct RenderedView;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// A session document, or a light field (an image or a folder), which a new session is made
  /// around. What goes wrong is shown in the status bar. True if the session is open.
  bool openSession(const QString& file);
  bool saveSession(const QString& file);
  /// Into the current state.
  bool importCalibration(const QString& file);

 private:
  void connectActions();
  void connectModel();
  void addDocks();
  void arrangeDocks();
  void connectDocks();
  void connectWorker();
  void askOpen();
  void askLightField();
  void askFolder();
  void save();
  void askSaveAs();
  void askImport();
  void showAbout();
  void showSession();
  void showContent();
  void load();
  void take(const Scene& scene);
  void showCurrent();
  void showTitle();
  void render();
  void showView(const RenderedView& view);
  void showError(const QString& line);
  void offerViews();
  void showStates();
  template <class Action>
  bool guarded(Action action);

  std::unique_ptr<Ui::MainWindow> m_ui;
  SessionModel* m_model;
  ViewWorker* m_worker;
  QComboBox* m_stateBox;
  std::unique_ptr<DisplayScene> m_scene;
  PictureCommands* m_pictures = nullptr;
  DistortionDock* m_distortion = nullptr;
  LightFieldDock* m_lightField = nullptr;
  DisplayParams m_display;              ///< resolved
  bool m_isNew = false;                 ///< the session: the scene has to be fitted to it
  std::optional<Scene> m_loaded;        ///< none while a light field is read, or cannot be
  Session m_asked;                      ///< whose light field was read last, or is read
  std::optional<NamedMethod> m_method;  ///< that the live view uses; none: the session's own
};

}  // namespace hogelscope
