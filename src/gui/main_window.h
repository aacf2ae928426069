// SPDX-License-Identifier: BSD-3-Clause
// The main window: puts scene, simulated view, docks and menus together. It decides nothing.
#pragma once

#include <QMainWindow>
#include <memory>

#include "core/lens_certificate.h"
#include "core/session.h"
#include "io/light_field_file.h"
#include "study/tradeoff.h"

class QComboBox;
class QLabel;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class ParameterForm;
class PictureCommands;
class SceneController;
class SessionModel;
class ViewWorker;
struct RenderedView;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// What goes wrong is shown in the status bar. True if the session is open.
  bool openSession(const QString& file);
  bool saveSession(const QString& file);
  /// Into the current state.
  bool importCalibration(const QString& file);

 private:
  void connectActions();
  void connectModel();
  void addEditing();
  void addForms();
  void askOpen();
  void save();
  void askSaveAs();
  void askImport();
  void showAbout();
  void showSession();
  void showCurrent();
  void showTitle();
  void render();
  void showView(const RenderedView& view);
  void showCertificate(const LensCertificate& certificate);
  void showError(const QString& line);
  void offerViews();
  void showStates();
  template <class Action>
  bool guarded(Action action);

  std::unique_ptr<Ui::MainWindow> m_ui;
  SessionModel* m_model;
  ViewWorker* m_worker;
  QComboBox* m_stateBox;
  QLabel* m_certificateLabel;
  SceneController* m_scene;
  PictureCommands* m_pictures = nullptr;
  std::vector<ParameterForm*> m_forms;
  std::optional<Scene> m_loaded;        ///< none while a light field is read
  std::optional<NamedMethod> m_method;  ///< that the live view uses; none: the session's own
};

}  // namespace hogelscope
