// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene as files: pictures of any size, and geometry for other programs.
#pragma once

#include <QObject>
#include <QSize>

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class ReadingBar;
class SceneController;
class SessionModel;
class Task;

class SceneOutput : public QObject {
  Q_OBJECT

 public:
  SceneOutput(const Ui::MainWindow& ui, SceneController* controller, SessionModel* model,
              QObject* parent);

  /// What the scene shows now; of the panel with as many pixels as the picture can show. Format by
  /// extension. done() or failed() come later.
  void savePicture(const QString& file, const QSize& size);
  /// exportScene(), likewise later.
  void exportTo(const QString& file);

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);

 private:
  void draw(const QString& file, const QSize& size);
  void finish(const QString& file);
  void askPicture();
  void askExport();
  void showState();

  const Ui::MainWindow& m_ui;
  SceneController* m_controller;
  SessionModel* m_model;
  QString m_file;  ///< that the task is for
  Task* m_task;
  ReadingBar* m_bar;
};

}  // namespace hogelscope
