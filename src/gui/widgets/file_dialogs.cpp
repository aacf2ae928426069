// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/file_dialogs.h"

#include <QAbstractItemView>
#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <QShortcut>

namespace hogelscope {

namespace {

constexpr const char* folderKey = "lastFolder";

QString lastFolder() {
  return QSettings().value(folderKey, QDir::homePath()).toString();
}

/// Disables Qt's deletion, renaming and moving of files. New folders can still be created for
/// output.
void keepFiles(QFileDialog& dialog) {
  QStringList hidden{"qt_rename_action", "qt_delete_action"};
  if (dialog.testOption(QFileDialog::ReadOnly)) hidden << "qt_new_folder_action";
  for (const QString& name : hidden)
    if (auto* action = dialog.findChild<QAction*>(name)) {
      action->setVisible(false);
      action->setEnabled(false);  // Qt 6.4 keeps the one for new folders enabled
    }
  for (auto* view : dialog.findChildren<QAbstractItemView*>()) {
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setDragDropMode(QAbstractItemView::NoDragDrop);
    for (auto* shortcut : view->findChildren<QShortcut*>()) shortcut->setEnabled(false);
  }
}

/// A dialog that also accepts the typed name of a new folder for output.
class FolderMaker : public QFileDialog {
 public:
  using QFileDialog::QFileDialog;

 protected:
  void accept() override {
    const QString folder = selectedFiles().value(0);
    if (fileMode() == Directory && !testOption(ReadOnly) && !folder.isEmpty())
      QDir().mkpath(folder);
    QFileDialog::accept();
  }
};

struct Asked {
  QFileDialog::FileMode mode = QFileDialog::ExistingFile;
  QFileDialog::Options options;
  QString filter;
};

QStringList chosen(QWidget* parent, const QString& title, const Asked& asked,
                   const QString& name = {}) {
  FolderMaker dialog(parent, title, lastFolder(), asked.filter);
  dialog.setOptions(asked.options);
  dialog.setFileMode(asked.mode);
  if (asked.mode == QFileDialog::AnyFile) dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.selectFile(name);
  keepFiles(dialog);
  QStringList files;
  if (dialog.exec() == QDialog::Accepted) files = dialog.selectedFiles();
  rememberFolderOf(files.value(0));
  return files;
}

}  // namespace

void rememberFolderOf(const QString& file) {
  if (!file.isEmpty()) QSettings().setValue(folderKey, QFileInfo(file).absolutePath());
}

QString sessionFilter() {
  return QCoreApplication::translate("FileDialogs", "Sessions (*.hogelscope *.json)");
}

QString lightFieldFilter(const QString& more) {
  return QCoreApplication::translate(
             "FileDialogs",
             "Light fields (*.png *.tif *.tiff *.jpg *.jpeg *.ppm *.pgx *.yuv *.exr *.avi *.mov "
             "*.mp4 *.m4v *.qt *.mj2 *.h5 *.glb *.gltf *.obj *.ply%1);;All files (*)")
      .arg(more);
}

QString chooseFile(QWidget* parent, const QString& title, const QString& filter) {
  return chosen(parent, title, {QFileDialog::ExistingFile, QFileDialog::ReadOnly, filter}).value(0);
}

QStringList chooseFiles(QWidget* parent, const QString& title, const QString& filter) {
  return chosen(parent, title, {QFileDialog::ExistingFiles, QFileDialog::ReadOnly, filter});
}

/// Remembers the parent of the chosen folder, because the next one is likely to lie there too.
QString chooseFolder(QWidget* parent, const QString& title) {
  const auto options = QFileDialog::ShowDirsOnly | QFileDialog::ReadOnly;
  return chosen(parent, title, {QFileDialog::Directory, options, {}}).value(0);
}

QString chooseOutputFolder(QWidget* parent, const QString& title) {
  return chosen(parent, title, {QFileDialog::Directory, QFileDialog::ShowDirsOnly, {}}).value(0);
}

QString chooseNewFile(QWidget* parent, const QString& title, const QString& name,
                      const QString& filter) {
  return chosen(parent, title, {QFileDialog::AnyFile, {}, filter}, name).value(0);
}

}  // namespace hogelscope
