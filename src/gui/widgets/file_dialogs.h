// SPDX-License-Identifier: BSD-3-Clause
// Dialogs for choosing files and folders. They open in the folder that was used last, also after a
// restart. They cannot delete, rename or move files; new folders can be created for output.
#pragma once

#include <QStringList>

class QWidget;

namespace hogelscope {

/// Returns the filter of session dialogs.
QString sessionFilter();
/// Returns that of the dialogs that ask for a light field; `more` are other patterns it offers.
QString lightFieldFilter(const QString& more = {});
/// What lightFieldFilter() offers where a session may stand for its light field.
inline constexpr const char* sessionPatterns = " *.hogelscope *.json";

/// Returns the chosen file, or "" if the user cancels; the same for all functions below. `filter`
/// is as in QFileDialog.
QString chooseFile(QWidget* parent, const QString& title, const QString& filter);
QStringList chooseFiles(QWidget* parent, const QString& title, const QString& filter);
QString chooseFolder(QWidget* parent, const QString& title);
/// Returns a folder for output, which the user may create.
QString chooseOutputFolder(QWidget* parent, const QString& title);
/// Returns a file to write; `name` is proposed in the folder that was used last.
QString chooseNewFile(QWidget* parent, const QString& title, const QString& name,
                      const QString& filter);

/// Remembers the folder of a file that was opened or saved without a dialog.
void rememberFolderOf(const QString& file);

}  // namespace hogelscope
