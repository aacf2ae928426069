// SPDX-License-Identifier: BSD-3-Clause
// The dialogs that ask for files and folders; they open in the folder that was used last, also in
// another run of the program. None deletes, renames or moves files; new folders can be made where
// something is to be written.
#pragma once

#include <QStringList>

class QWidget;

namespace hogelscope {

/// Returns the filter of the dialogs that ask for a session.
QString sessionFilter();
/// Returns that of the dialogs that ask for a light field; `more` are other patterns it offers.
QString lightFieldFilter(const QString& more = {});
/// What lightFieldFilter() offers where a session may stand for its light field.
inline constexpr const char* sessionPatterns = " *.hogelscope *.json";

/// All of them return nothing where the user does not choose. `filter` is as QFileDialog's.
QString chooseFile(QWidget* parent, const QString& title, const QString& filter);
QStringList chooseFiles(QWidget* parent, const QString& title, const QString& filter);
QString chooseFolder(QWidget* parent, const QString& title);
/// The folder is written into; the user may make a new one.
QString chooseOutputFolder(QWidget* parent, const QString& title);
/// `name` is proposed: of a file in the folder that was used last.
QString chooseNewFile(QWidget* parent, const QString& title, const QString& name,
                      const QString& filter);

/// The folder of a file that was opened or saved without a dialog is used too.
void rememberFolderOf(const QString& file);

}  // namespace hogelscope
