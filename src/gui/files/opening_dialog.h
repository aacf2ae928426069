// SPDX-License-Identifier: BSD-3-Clause
// Dialog of the assumptions about a light field that is opened without a session, with a preview of
// its views. Each assumption can be corrected, and a quilt shown on a lens sheet.
#pragma once

#include <QDialog>
#include <memory>

#include "io/opening/opening.h"

namespace Ui {
class OpeningDialog;
}

namespace hogelscope {

class ParameterForm;
class Task;

class OpeningDialog : public QDialog {
  Q_OBJECT

 public:
  /// Takes the result of the first analysis; `sheet` is the calibration of a lens sheet, or "".
  OpeningDialog(const QString& file, const Opening& opening, const QString& sheet, QWidget* window);
  ~OpeningDialog() override;

  /// Returns the corrected assumptions after the dialog is accepted, with the session of the chosen
  /// display. Throws InputError if the lens sheet's calibration cannot be read.
  [[nodiscard]] Opening opening() const;

 private:
  void addForms();
  void listDisplays();
  void chooseDisplay(int index);
  [[nodiscard]] bool isOnSheet() const;
  void edit(const Session& edited);
  void look(bool isKnown);
  void start(bool isKnown);
  void takeNext();
  void showOpening(const Opening& opening);
  void showProblem(const QString& problem);
  void showFields();

  std::unique_ptr<Ui::OpeningDialog> m_ui;
  QString m_file;
  SaidFields m_said;
  QString m_sheet;         ///< the calibration; "": a display of hogels
  Opening m_opening;       ///< for hogels
  Session m_shown;         ///< the values in the fields
  bool m_isStale = false;  ///< an edit waits for the running task to stop
  ParameterForm* m_lightField;
  ParameterForm* m_display;
  Task* m_task;
};

}  // namespace hogelscope
