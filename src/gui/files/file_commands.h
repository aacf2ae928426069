// SPDX-License-Identifier: BSD-3-Clause
// The File menu: opens, saves and imports through dialogs, recent files, drops and the command
// line; asks before edits are lost, and keeps them through a crash.
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

class QAction;
class QImage;
class QMenu;
class QWidget;

namespace hogelscope {

class Autosave;
class FileWatch;
class OpeningDialog;
class RecentFiles;
class SessionModel;
class Task;
struct CameraState;
struct Opening;

class FileCommands : public QObject {
  Q_OBJECT

 public:
  /// Fills the menu and takes files dropped onto `window`, which owns it.
  FileCommands(QMenu* menu, SessionModel* model, QWidget* window);

  /// Enables the commands that need a session.
  void setOpen(bool isOpen);
  [[nodiscard]] QAction* importAction() const { return m_import; }
  /// Returns the share of a light field that has been looked at, 0 … 1.
  [[nodiscard]] double lookedShare() const;
  void stopLooking();
  /// Opens what was opened last again, with a choice of what was assumed of it.
  [[nodiscard]] QAction* changeAction() const { return m_change; }

  /// These functions ask nothing, report errors through failed(), and return true on success. A
  /// session document opens at once. A light field (an image, a folder or a mesh) opens later in a
  /// new session, after it has been analysed; uncertain results are then asked about.
  bool open(const QString& file);
  bool save(const QString& file);
  /// Imports a calibration into the current state.
  bool importCalibration(const QString& file);

  /// Opens files of the command line or a drop: a session opens, a camera's calibration goes
  /// to the current state, and the open session is compared with a light field. A mesh, and a light
  /// field that cannot be compared, opens in a new session; a calibration without a session creates
  /// one. With a lens sheet's calibration another file is a quilt, which opens on that sheet;
  /// without one the session's quilt does, or one that is asked for.
  void openFiles(const QStringList& files);
  /// Returns true if there are no edits, or they have been saved or discarded.
  bool mayLeave();
  /// Removes the recovery copy when the window closes.
  void end();
  void offerRecovery();
  /// Keeps a small copy of the first view of a file that was opened or saved, for the list of
  /// recent files.
  void keepThumbnail(const QImage& view);

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);
  void comparisonAsked(const QString& file);
  /// A light field that is to be opened is being looked at; "": no longer.
  void looking(const QString& line);
  /// A light field was opened, of which this was assumed.
  void assumed(const QString& line);
  void lightFieldChanged();  ///< its file, by another program

 private:
  void addCommands(QMenu* menu);
  bool eventFilter(QObject* watched, QEvent* event) override;
  void openLater(const QString& file, bool isAsked, const QString& sheet = {});
  void openSheet(const QString& calibration, const QString& quilt);
  void offer(const QString& file, const Opening& opening, bool isAsked, const QString& sheet);
  void ask(const QString& file, const Opening& opening, const QString& sheet);
  void take(const QString& file, const Opening& opening);
  void compareOrOpen(const QString& file);
  void openCalibration(const QString& file);
  bool takeCalibration(const QString& file, CameraState& state);
  void checkOrder(const QString& file);
  void remember(const QString& file, const QString& what);
  void rememberSession(const QString& file);
  void openAny(const QString& file, bool isFirst);
  bool saveOrAsk();
  bool askSaveAs();
  void openChosen(const QString& file);
  void askLightField(bool isAsked);
  void askImport();
  void askLightFieldsPlace();
  void watchFiles();
  void takeChange(const QString& path);

  SessionModel* m_model;
  QWidget* m_window;
  RecentFiles* m_recent = nullptr;
  QString m_unpictured;  ///< a recent file whose first view has not been rendered yet
  QAction *m_save = nullptr, *m_saveAs = nullptr, *m_import = nullptr, *m_locate = nullptr,
          *m_change = nullptr;
  QString m_assumedOf;  ///< the light field that the session was made around; "": none
  bool m_isLooking = false;
  bool m_isOther = false;  ///< the session's file has been changed by another program
  Task* m_task;            ///< analyses a light field that is being opened
  Task* m_compared;        ///< checks whether a light field can be compared
  QPointer<OpeningDialog> m_dialog;
  Autosave* m_autosave;
  FileWatch* m_watch;
};

}  // namespace hogelscope
