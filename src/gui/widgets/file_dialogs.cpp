// SPDX-License-Identifier: BSD-3-Clause
// File dialogs.
#include "gui/widgets/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QSettings>

namespace hogelscope {

namespace {

constexpr const char* folderKey = "lastFolder";

QString lastFolder() {
  return QSettings().value(folderKey, QDir::homePath()).toString();
}

}  // namespace

void rememberFolderOf(const QString& file) {
  if (!file.isEmpty()) QSettings().setValue(folderKey, QFileInfo(file).absolutePath());
}

QString sessionFilter() {
  return QCoreApplication::translate("FileDialogs", "Sessions (*.hogelscope *.json)");
}

QString chooseFile(QWidget* parent, const QString& title, const QString& filter) {
  QString file = QFileDialog::getOpenFileName(parent, title, lastFolder(), filter);
  rememberFolderOf(file);
  return file;
}

QStringList chooseFiles(QWidget* parent, const QString& title, const QString& filter) {
  QStringList files = QFileDialog::getOpenFileNames(parent, title, lastFolder(), filter);
  rememberFolderOf(files.value(0));
  return files;
}

/// The folder around the one that is chosen: the next one is likely to lie beside it.
QString chooseFolder(QWidget* parent, const QString& title) {
  QString folder = QFileDialog::getExistingDirectory(parent, title, lastFolder());
  rememberFolderOf(folder);
  return folder;
}

QString chooseNewFile(QWidget* parent, const QString& title, const QString& name,
                      const QString& filter) {
  QString file =
      QFileDialog::getSaveFileName(parent, title, QDir(lastFolder()).filePath(name), filter);
  rememberFolderOf(file);
  return file;
}

}  // namespace hogelscope
