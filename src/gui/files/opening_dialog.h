// SPDX-License-Identifier: BSD-3-Clause
// Shows what is assumed of a light field that is opened without a session, and how its views look
// then; each assumption can be corrected.
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
  /// What has been found out already.
  OpeningDialog(const QString& file, const Opening& opening, QWidget* window);
  ~OpeningDialog() override;

  /// What is assumed now, once the dialog is accepted.
  [[nodiscard]] const Opening& opening() const { return m_opening; }

 private:
  void addForms();
  void edit(const Session& edited);
  void look(bool isKnown);
  void start(bool isKnown);
  void takeNext();
  void showOpening(const Opening& opening);
  void showPreview(const Image& picture);
  void showProblem(const QString& problem);
  void showFields();

  std::unique_ptr<Ui::OpeningDialog> m_ui;
  QString m_file;
  SaidFields m_said;
  Opening m_opening;
  Session m_shown;         ///< in the fields
  bool m_isStale = false;  ///< an edit waits for the task to stop
  ParameterForm* m_lightField;
  ParameterForm* m_display;
  Task* m_task;
};

}  // namespace hogelscope
