// SPDX-License-Identifier: BSD-3-Clause
// The File menu: opening, saving and importing, by dialogs, recent files, drops and the command
// line; asks before edits are lost, and keeps them through a crash.
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

class QWidget;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class Autosave;
class OpeningDialog;
class RecentFiles;
class SessionModel;
class Task;
struct Opening;

class FileCommands : public QObject {
  Q_OBJECT

 public:
  FileCommands(const Ui::MainWindow& ui, SessionModel* model, QWidget* window);

  /// These do not ask, and report errors through failed(). True if it is done. A session document
  /// opens, or a light field (an image, a folder or a mesh), which a new session is made around. It
  /// does so later, when that has been looked at; what is in doubt then is asked.
  bool open(const QString& file);
  bool save(const QString& file);
  /// Into the current state.
  bool importCalibration(const QString& file);

  /// Of the command line or dropped: a session opens, a calibration (*.yml, *.yaml) goes to the
  /// current state, and the open session is compared with a light field. A mesh, and a light field
  /// that cannot be compared, opens as a new session; a calibration without a session has one made.
  void openFiles(const QStringList& files);
  /// True if there are no edits, or they are saved or not wanted any more.
  bool mayLeave();
  /// The window closes: no edits are left to recover.
  void end();
  void offerRecovery();

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);
  void comparisonAsked(const QString& file);

 private:
  template <class Action>
  bool guarded(Action action);
  void openLater(const QString& file, bool isAsked);
  void offer(const QString& file, const Opening& opening, bool isAsked);
  void ask(const QString& file, const Opening& opening);
  void take(const QString& file, const Opening& opening);
  void compareOrOpen(const QString& file);
  void openCalibration(const QString& file);
  void checkOrder(const QString& file);
  void openAny(const QString& file, bool isFirst);
  bool saveOrAsk();
  bool askSaveAs();
  void askOpen();
  void askLightField(bool isAsked);
  void askFolder();
  void askImport();

  SessionModel* m_model;
  QWidget* m_window;
  RecentFiles* m_recent;
  Task* m_task;      ///< looks at a light field that is opened
  Task* m_compared;  ///< looks whether one can be compared
  QPointer<OpeningDialog> m_dialog;
  Autosave* m_autosave;
};

}  // namespace hogelscope
