// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/file_commands.h"

#include <QAction>
#include <QDropEvent>
#include <QFileInfo>
#include <QImage>
#include <QInputDialog>
#include <QMimeData>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "gui/files/autosave.h"
#include "gui/files/file_watch.h"
#include "gui/files/opening_dialog.h"
#include "gui/files/recent_files.h"
#include "gui/session/session_model.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "gui/widgets/task.h"
#include "io/cameras/camera_file.h"
#include "io/documents/session_file.h"
#include "io/documents/sheet_file.h"
#include "io/opening/opening.h"
#include "io/scene/live_file.h"

namespace hogelscope {

namespace {

/// Whether a file has a camera's calibration; a YAML file is meant for one, even if it has none.
bool isCalibration(const QString& file) {
  const QString suffix = QFileInfo(file).suffix().toLower();
  return suffix == "yml" || suffix == "yaml" ||
         (!isMeshFile(file.toStdString()) && QFileInfo(file).isFile() &&
          isCameraFile(file.toStdString()));
}

/// Returns what a session is made around, in words for the list of recent files.
QString whatIs(const Session& session) {
  const auto& [across, down] = session.display.directions;
  const auto& [columns, rows] = session.display.hogels;
  if (session.lightField.isLive()) return FileCommands::tr("3-D scene");
  if (isGridOfViews(session.lightField.layout))
    return FileCommands::tr("Views %1 × %2").arg(across).arg(down);
  return FileCommands::tr("Hogels %1 × %2 of %3 × %4").arg(columns).arg(rows).arg(across).arg(down);
}

QStringList filesOf(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) files.append(url.toLocalFile());
  return files;
}

QString fullPath(const QString& file) {
  return file.isEmpty() ? file : QFileInfo(file).absoluteFilePath();
}

/// Returns the light field's file or folder; "" if it has none.
QString lightFieldPath(const Session& session) {
  const LightFieldParams& lightField = session.lightField;
  const std::string none = lightField.isLive() ? lightField.source : std::string();
  const std::string name = contentName(lightField);
  return name == none ? QString() : fullPath(QString::fromStdString(name));
}

/// Returns what is seen of an opened light field, and what was assumed of it, in one line; "" where
/// nothing was.
QString assumedText(const Opening& opening) {
  QStringList guesses, usual;
  QString size;
  const bool isSheet = opening.around.session.display.sheet.has_value();
  for (const Assumption& each : opening.assumptions) {
    const QString value = QString::fromStdString(each.value);
    const QString what = QString::fromStdString(each.what).toLower();
    const bool isOfHogels = each.what == "Panel" || each.what == "Field of view";
    if (each.what == "Size")
      size = value;
    else if (each.isUsual && isOfHogels && !isSheet)
      usual << what + " " + value;
    if (each.sureness != Sureness::sure && !each.isUsual)
      guesses << FileCommands::tr("%1 %2").arg(what, nameOf(each.sureness));
  }
  if (guesses.isEmpty() && usual.isEmpty()) return {};
  QString line = size;
  if (!usual.isEmpty()) line += FileCommands::tr(" · assumed: %1").arg(usual.join(", "));
  if (!guesses.isEmpty()) line += FileCommands::tr(" · please check: %1").arg(guesses.join(", "));
  return line;
}

/// Whether a session's file can be replaced; false for samples that the system owns.
bool mayBeWritten(const QString& file) {
  const QFileInfo info(file);
  return QFileInfo(info.absolutePath()).isWritable() && (!info.exists() || info.isWritable());
}

}  // namespace

FileCommands::FileCommands(QMenu* menu, SessionModel* model, QWidget* window)
    : QObject(window),
      m_model(model),
      m_window(window),
      m_task(new Task(this)),
      m_compared(new Task(this)),
      m_autosave(new Autosave(model, this)),
      m_watch(new FileWatch(this)) {
  addCommands(menu);
  connect(m_recent, &RecentFiles::chosen, this, &FileCommands::openChosen);
  connect(m_autosave, &Autosave::failed, this, &FileCommands::failed);
  for (const Task* task : {m_task, m_compared})
    connect(task, &Task::failed, this, &FileCommands::failed);
  connect(m_task, &Task::stopped, this, [this] { Q_EMIT done(tr("Stopped; nothing was opened")); });
  connect(m_task, &Task::runningChanged, this, [this](bool isRunning) {
    if (!isRunning && std::exchange(m_isLooking, false)) Q_EMIT looking({});
  });
  for (const auto change : {&SessionModel::opened, &SessionModel::contentChanged})
    connect(m_model, change, this, &FileCommands::watchFiles);
  connect(m_model, &SessionModel::saved, this, [this] {
    watchFiles();
    m_watch->know(fullPath(m_model->file()));
  });
  for (const auto change : {&SessionModel::opened, &SessionModel::contentChanged})
    connect(m_model, change, this, [this] {
      const auto& sheet = m_model->session().display.sheet;
      if (sheet && !sheet->file.empty()) rememberSheet(QString::fromStdString(sheet->file));
    });
  // The next picture is of another session than the file that waits for one.
  connect(m_model, &SessionModel::opened, this, [this] {
    m_unpictured.clear();
    m_assumedOf.clear();
    m_isOther = false;
  });
  connect(m_watch, &FileWatch::changed, this, &FileCommands::takeChange);
  window->setAcceptDrops(true);
  window->installEventFilter(this);
}

void FileCommands::addCommands(QMenu* menu) {
  const auto add = [this, menu](const CommandText& text, auto slot) {
    return addCommand(menu, text, this, slot);
  };
  add({"newAction", tr("&New session"),
       tr("A display that shows the built-in test scene, to be changed"),
       Qt::CTRL | Qt::ALT | Qt::Key_N},
      [this] {
        if (mayLeave()) m_model->openNew(newSession());
      });
  add({"openAction", tr("&Open session…"),
       tr("Opens a session: display, light field and camera states; or shows a quilt on the lens "
          "sheet of a visual.json"),
       Qt::CTRL | Qt::Key_O, tr("Open")},
      [this] { openChosen(chooseFile(m_window, tr("Open session"), sessionFilter())); });
  auto* recent = menu->addMenu(tr("Open &recent"));
  recent->setObjectName("recentMenu");
  m_recent = new RecentFiles(recent, this);
  add({"openLightFieldAction", tr("Open &light field…"),
       tr("Makes a new session around a picture: hogels, or tiles of views"),
       Qt::CTRL | Qt::ALT | Qt::Key_O},
      [this] { askLightField(false); });
  add({"openFolderAction", tr("Open &folder of views…"),
       tr("Makes a new session around a folder of sub-aperture pictures"),
       Qt::CTRL | Qt::ALT | Qt::Key_F},
      [this] { openChosen(chooseFolder(m_window, tr("Open folder of views"))); });
  add({"openLightFieldAsAction", tr("Open light field as…"),
       tr("Shows what is assumed of a picture, or of the folder of views that it is in, before it "
          "opens"),
       Qt::CTRL | Qt::ALT | Qt::SHIFT | Qt::Key_O},
      [this] { askLightField(true); });
  m_change = add({"changeOpeningAction", tr("C&hange what was assumed…"),
                  tr("Opens the same light field again, with a choice of what was assumed of it"),
                  Qt::CTRL | Qt::ALT | Qt::Key_H, tr("Change…")},
                 [this] {
                   if (mayLeave()) openLater(m_assumedOf, true);
                 });
  m_save = add({"saveAction", tr("&Save session"),
                tr("Saves the session with all camera states as they are now"),
                Qt::CTRL | Qt::Key_S, tr("Save")},
               &FileCommands::saveOrAsk);
  m_saveAs = add({"saveAsAction", tr("Save session &as…"), tr("Saves the session to another file"),
                  Qt::CTRL | Qt::SHIFT | Qt::Key_S},
                 &FileCommands::askSaveAs);
  m_locate = add({"locateFileAction", tr("Lo&cate file…"),
                  tr("Says where the session's light field is, if its file is missing"),
                  Qt::CTRL | Qt::ALT | Qt::Key_J},
                 &FileCommands::askLightFieldsPlace);
  menu->addSeparator();
  m_import = add({"importAction", tr("&Import calibration…"),
                  tr("Gives the current state the lens, the intrinsics and the picture size of a "
                     "camera's file: OpenCV, ROS, Kalibr, transforms.json, COLMAP or glTF"),
                  Qt::CTRL | Qt::Key_I},
                 &FileCommands::askImport);
}

void FileCommands::setOpen(bool isOpen) {
  for (QAction* action : {m_save, m_saveAs, m_import}) action->setEnabled(isOpen);
  m_change->setEnabled(isOpen && !m_assumedOf.isEmpty());
  const QString lightField = lightFieldPath(m_model->session());
  m_locate->setEnabled(isOpen && !lightField.isEmpty() && !QFileInfo::exists(lightField));
}

/// Takes files and folders dropped onto the window. They are opened after the drop, because a
/// dialog would block the other program.
bool FileCommands::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop) return false;
  auto* drop = static_cast<QDropEvent*>(event);
  const QStringList files = filesOf(*drop->mimeData());
  if (files.isEmpty()) return false;
  drop->acceptProposedAction();
  const auto open = [this, files] { openFiles(files); };
  if (event->type() == QEvent::Drop) QMetaObject::invokeMethod(this, open, Qt::QueuedConnection);
  return true;
}

bool FileCommands::open(const QString& file) {
  if (!isSessionDocument(file.toStdString())) {
    openLater(file, false);
    return true;
  }
  m_task->abandon();
  m_compared->abandon();
  return guarded(this, [&] {
    m_model->open(file);
    rememberSession(file);
    checkOrder(file);
  });
}

/// Opens a file after it has been analysed on another thread, which finds the display that fits it,
/// its hogels or the order of its views. Certain results are not asked about unless `isAsked`.
/// `sheet` is the calibration of the lens sheet that shows it; "": hogels do.
void FileCommands::openLater(const QString& file, bool isAsked, const QString& sheet) {
  delete m_dialog;
  m_isLooking = true;
  m_task->start([this, file, isAsked, sheet](const Progress& progress) {
    return [this, file, isAsked, sheet, opening = inspectFile(file.toStdString(), {}, progress)] {
      offer(file, opening, isAsked, sheet);
    };
  });
  const QString line = tr("Reading %1 …").arg(file);
  Q_EMIT done(line);
  Q_EMIT looking(line);
}

double FileCommands::lookedShare() const {
  return m_task->share();
}

void FileCommands::stopLooking() {
  m_task->stop();
}

/// Shows a quilt on a lens sheet: without a file the session's, or one that is asked for. A session
/// of a sheet gets the other calibration.
void FileCommands::openSheet(const QString& calibration, const QString& quilt) {
  guarded(this, [&] {
    const std::string sheet = calibration.toStdString();
    Session session = m_model->session();
    const bool isSheet = session.display.sheet.has_value();
    session.display = withCalibration(session.display, sheet);  // before a quilt is asked for
    for (const std::string& warning : sheetWarnings(session))
      Q_EMIT failed(calibration + ": " + QString::fromStdString(warning));
    if (quilt.isEmpty() && isSheet) return m_model->setContent(session);
    if (quilt.isEmpty() && session.lightField.layout == Layout::quilt) {
      if (mayLeave()) m_model->openNew(onSheet(session.lightField, sheet));
      return;
    }
    const QString file = quilt.isEmpty() ? chooseFile(m_window,
                                                      tr("Choose a quilt for the lens sheet of %1")
                                                          .arg(QFileInfo(calibration).fileName()),
                                                      lightFieldFilter())
                                         : quilt;
    if (!file.isEmpty() && mayLeave()) openLater(file, false, calibration);
  });
}

void FileCommands::offer(const QString& file, const Opening& opening, bool isAsked,
                         const QString& sheet) {
  const bool isLive = opening.around.session.lightField.isLive();
  if (!isLive && (isAsked || isInDoubt(opening))) return ask(file, opening, sheet);
  guarded(this, [&] {
    Opening shown = opening;
    Session& session = shown.around.session;
    if (!sheet.isEmpty()) session = onSheet(session.lightField, sheet.toStdString());
    take(file, shown);
    for (const std::string& warning : opening.around.order.warnings)
      Q_EMIT failed(file + ": " + QString::fromStdString(warning));
  });
}

/// Opens the dialog. The window stays unchanged until the dialog is accepted.
void FileCommands::ask(const QString& file, const Opening& opening, const QString& sheet) {
  m_dialog = new OpeningDialog(file, opening, sheet, m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_dialog, &QDialog::accepted, this,
          [this, file] { guarded(this, [&] { take(file, m_dialog->opening()); }); });
  connect(m_dialog, &QDialog::rejected, this,
          [this, file] { Q_EMIT done(tr("%1: not opened").arg(file)); });
  m_dialog->open();
}

void FileCommands::take(const QString& file, const Opening& opening) {
  const OrderedSession& around = opening.around;
  m_model->openNew(around.session);
  if (const QString line = assumedText(opening); !line.isEmpty()) {
    m_assumedOf = file;
    m_change->setEnabled(true);
    Q_EMIT assumed(line);
  }
  remember(file, whatIs(shownOf(opening)));
  const LightFieldParams& used = around.session.lightField;
  if (!around.assumed.empty()) Q_EMIT done(file + ": " + QString::fromStdString(around.assumed));
  if (isGridOfViews(used.layout))
    Q_EMIT done(
        tr("%1: rows %2, columns %3 (%4)")
            .arg(file, nameOf(used.rows), nameOf(used.columns), nameOf(around.order.sureness)));
}

/// Checks the session's views in the background. Reports an error if the images indicate another
/// order, if views are missing, or if lenslets are not on a regular grid.
void FileCommands::checkOrder(const QString& file) {
  m_task->start(
      [this, file, session = m_model->session()](const Progress& progress) -> Task::Answer {
        std::vector<std::string> lines;
        try {
          lines = examine(session.lightField, session.display, progress);
          std::ranges::copy(sheetWarnings(session), std::back_inserter(lines));
        } catch (const InputError&) {  // the view says it
        }
        return [this, file, lines] {
          for (const std::string& line : lines)
            Q_EMIT failed(file + ": " + QString::fromStdString(line));
        };
      });
}

void FileCommands::remember(const QString& file, const QString& what) {
  RecentFiles::add(file, what);
  rememberFolderOf(file);
  m_unpictured = file;
}

void FileCommands::rememberSession(const QString& file) {
  remember(file, tr("Session · %n states", "", int(m_model->session().cameras.size())));
}

void FileCommands::keepThumbnail(const QImage& view) {
  if (!m_unpictured.isEmpty()) RecentFiles::setThumbnail(std::exchange(m_unpictured, {}), view);
}

bool FileCommands::save(const QString& file) {
  return guarded(this, [&] {
    m_model->save(file);
    m_isOther = false;
    rememberSession(file);
    Q_EMIT done(tr("Saved %1").arg(file));
  });
}

bool FileCommands::importCalibration(const QString& file) {
  return guarded(this, [&] {
    CameraState state = m_model->current();
    if (takeCalibration(file, state)) m_model->setCurrent(state);
  });
}

/// Gives a state the camera of a file, of several the one that the user chooses, and says what was
/// guessed of it. Returns false if none was chosen. Throws InputError.
bool FileCommands::takeCalibration(const QString& file, CameraState& state) {
  const CameraFile cameras = readCameraFile(file.toStdString(), CameraUse::lens);
  QStringList names;
  for (const std::string& name : differingCameras(cameras)) names << QString::fromStdString(name);
  bool isChosen = true;
  const QString name =
      names.isEmpty() ? QString()
                      : QInputDialog::getItem(m_window, tr("Import calibration"),
                                              tr("Camera of %1").arg(QFileInfo(file).fileName()),
                                              names, 0, false, &isChosen);
  if (!isChosen) return false;
  std::vector<std::string> notes;
  const Calibration calibration = loadCalibration(file.toStdString(), name.toStdString(), &notes);
  apply(calibration, state);
  notes.push_back(sizeWarning(calibration, state.camera.res));
  for (const std::string& note : notes)
    if (!note.empty()) Q_EMIT failed(file + ": " + QString::fromStdString(note));
  return true;
}

void FileCommands::watchFiles() {
  QStringList files{fullPath(m_model->file()), lightFieldPath(m_model->session())};
  files.removeAll(QString());
  m_watch->watch(files);
}

/// Reads what another program has written, but never over edits.
void FileCommands::takeChange(const QString& path) {
  if (path == lightFieldPath(m_model->session())) return Q_EMIT lightFieldChanged();
  m_isOther = m_model->isModified();
  if (m_isOther)
    return Q_EMIT failed(
        tr("%1 has been changed by another program, and here: open it again to take that, or save "
           "to replace it")
            .arg(path));
  guarded(this, [&] {
    m_model->reload();
    Q_EMIT done(tr("Read %1 again").arg(path));
  });
}

void FileCommands::openFiles(const QStringList& files) {
  QStringList sorted = files;
  const auto sheet = std::ranges::find_if(
      sorted, [](const QString& file) { return isSheetCalibration(file.toStdString()); });
  if (sheet != sorted.end()) {
    const QString calibration = sorted.takeAt(sheet - sorted.begin());
    const QString other = sorted.value(0);
    const bool isSession = isSessionDocument(other.toStdString());
    if (isSession && !(mayLeave() && open(other))) return;
    return openSheet(calibration, isSession ? QString() : other);
  }
  // The session first.
  std::stable_partition(sorted.begin(), sorted.end(), [](const QString& file) {
    return isSessionFile(file.toStdString()) && !isCalibration(file);
  });
  for (qsizetype k = 0; k < sorted.size(); ++k) openAny(sorted[k], k == 0);
}

/// Opens one of several files. Only the first may be the session; a second one is a light field to
/// compare with.
void FileCommands::openAny(const QString& file, bool isFirst) {
  const bool isOfCamera = isCalibration(file);
  const bool isOpen = !m_model->session().cameras.empty();
  const bool isWhole =
      !isOfCamera && (isSessionFile(file.toStdString()) || isMeshFile(file.toStdString()));
  if (isFirst && (isWhole || !(isOpen || isOfCamera))) {
    if (mayLeave()) open(file);
  } else if (isFirst && isOfCamera && !isOpen) {
    openCalibration(file);
  } else if (!isOpen) {
    Q_EMIT failed(tr("%1: needs an open session (*.hogelscope, *.json)").arg(file));
  } else if (isOfCamera) {
    importCalibration(file);
  } else {
    compareOrOpen(file);
  }
}

/// Compares a light field with the session's, or opens it if the session's display cannot show it.
void FileCommands::compareOrOpen(const QString& file) {
  m_compared->start(
      [this, file, session = m_model->session()](const Progress& progress) -> Task::Answer {
        if (canCompare(session, file.toStdString(), progress))
          return [this, file] { Q_EMIT comparisonAsked(file); };
        return [this, file, opening = inspectFile(file.toStdString(), {}, progress)] {
          if (mayLeave()) offer(file, opening, false, {});
        };
      });
}

/// Imports a calibration into a new session, which shows the effect of the lens.
void FileCommands::openCalibration(const QString& file) {
  guarded(this, [&] {
    Session session = newSession();
    if (takeCalibration(file, session.cameras.front())) m_model->openNew(session);
  });
}

bool FileCommands::mayLeave() {
  if (!m_model->isModified()) return true;
  const QString name =
      m_model->file().isEmpty() ? tr("The session") : QFileInfo(m_model->file()).fileName();
  const QMessageBox::StandardButton answer = askUnsaved(m_window, name);
  return answer == QMessageBox::Save ? saveOrAsk() : answer == QMessageBox::Discard;
}

void FileCommands::end() {
  m_autosave->forget();
}

void FileCommands::offerRecovery() {
  m_autosave->offerRecovery(m_window);
}

/// Saves the session to its file, but asks for another one where that cannot be written, and before
/// it replaces what another program has written.
bool FileCommands::saveOrAsk() {
  const QString file = m_model->file();
  if (file.isEmpty() || !mayBeWritten(file)) return askSaveAs();
  if (!m_isOther) return save(file);
  const std::optional<bool> isSame =
      askEither(m_window, tr("Save session"),
                tr("%1 has been changed by another program since it was opened.")
                    .arg(QFileInfo(file).fileName()),
                {tr("Save to &another file…"), tr("&Replace it")});
  return isSame && (*isSame ? askSaveAs() : save(file));
}

bool FileCommands::askSaveAs() {
  const QString file = chooseNewFile(m_window, tr("Save session as"),
                                     QFileInfo(m_model->file()).fileName(), sessionFilter());
  return !file.isEmpty() && save(file);
}

/// Opens what the user has chosen, if anything.
void FileCommands::openChosen(const QString& file) {
  if (isSheetCalibration(file.toStdString())) return openSheet(file, {});
  if (!file.isEmpty() && mayLeave()) open(file);
}

void FileCommands::askLightField(bool isAsked) {
  const QString file = chooseFile(m_window, tr("Open light field"), lightFieldFilter());
  if (!file.isEmpty() && mayLeave()) isAsked ? openLater(file, true) : void(open(file));
}

void FileCommands::askImport() {
  const QString file =
      chooseFile(m_window, tr("Import calibration"),
                 tr("Calibrations (*.yml *.yaml *.json *.xml *.txt *.bin);;All files (*)"));
  if (!file.isEmpty()) importCalibration(file);
}

void FileCommands::askLightFieldsPlace() {
  const QFileInfo missing(lightFieldPath(m_model->session()));
  const QString title = tr("Locate %1").arg(missing.fileName());
  const QString file = missing.suffix().isEmpty() ? chooseFolder(m_window, title)
                                                  : chooseFile(m_window, title, lightFieldFilter());
  if (file.isEmpty()) return;
  guarded(this, [&] {
    Session content = m_model->session();
    if (content.lightField.isLive())
      content.lightField.content.set("file", file.toStdString());
    else
      content.lightField.file = file.toStdString();
    m_model->setContent(content);
  });
}

}  // namespace hogelscope
