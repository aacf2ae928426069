// SPDX-License-Identifier: BSD-3-Clause
// Modal message boxes, which wait for their answer; the dialog of the size of an image in pixels;
// dialogs for choosing files and folders, which open in the folder that was used last, also after
// a restart, and cannot delete, rename or move files (new folders can be created for output).
#pragma once

#include <QDateTime>
#include <QDialog>
#include <QMessageBox>
#include <QString>
#include <QStringList>
#include <array>
#include <memory>
#include <optional>

class QFormLayout;

namespace Ui {
class SizeDialog;
}

namespace hogelscope {

/// Asks before edits of `name` would be lost: Save, Discard or Cancel. Escape cancels.
QMessageBox::StandardButton askUnsaved(QWidget* window, const QString& name);

/// Asks for one of two ways, the first of which is proposed. Returns whether it is the first; none
/// if the user cancels.
std::optional<bool> askEither(QWidget* window, const QString& title, const QString& text,
                              const std::array<QString, 2>& ways);

enum class Recovery { recover, discard, later };
/// Asks about edits of `document`, dated `time`, that a crash left behind. Escape means later.
Recovery askRecovery(QWidget* window, const QString& document, const QDateTime& time);

void showAbout(QWidget* window);

/// Returns the filter of session dialogs.
QString sessionFilter();
/// Returns the filter of light field dialogs; `more` are other patterns it offers.
QString lightFieldFilter(const QString& more = {});
/// The patterns that lightFieldFilter() adds if a session may stand for its light field.
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

/// Asks for a lens sheet's calibration.
QString chooseSheet(QWidget* parent);
/// Returns the calibration that was used last; "" if there is none, or it is not there any more.
QString lastSheet();
void rememberSheet(const QString& calibration);

/// Dialog of the size of an image in pixels.
class SizeDialog : public QDialog {
  Q_OBJECT

 public:
  /// Keeps the aspect ratio of `proposed`.
  SizeDialog(const QString& title, const QSize& proposed, QWidget* parent);
  ~SizeDialog() override;

  /// Returns the size, at least one pixel each way.
  [[nodiscard]] QSize size() const;

 protected:
  /// The layout, for further rows.
  [[nodiscard]] QFormLayout* form() const;

 private:
  QSize m_proposed;
  std::unique_ptr<Ui::SizeDialog> m_ui;
};

}  // namespace hogelscope
