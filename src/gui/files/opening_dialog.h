// SPDX-License-Identifier: BSD-3-Clause
// Dialog of the assumptions about a light field that is opened without a session, with a preview of
// its views. Each assumption can be corrected.
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
  /// Takes the result of the first analysis.
  OpeningDialog(const QString& file, const Opening& opening, QWidget* window);
  ~OpeningDialog() override;

  /// Returns the corrected assumptions after the dialog is accepted.
  [[nodiscard]] const Opening& opening() const { return m_opening; }

 private:
  void addForms();
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
  Opening m_opening;
  Session m_shown;         ///< the values in the fields
  bool m_isStale = false;  ///< an edit waits for the running task to stop
  ParameterForm* m_lightField;
  ParameterForm* m_display;
  Task* m_task;
};

}  // namespace hogelscope
