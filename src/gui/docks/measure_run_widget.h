// SPDX-License-Identifier: BSD-3-Clause
// The button that measures all figures of --measure for the current state, with its progress, and
// the one that opens the page.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace hogelscope {

class SessionModel;
class Task;

class MeasureRunWidget : public QWidget {
  Q_OBJECT

 public:
  explicit MeasureRunWidget(SessionModel* model, QWidget* parent = nullptr);
  ~MeasureRunWidget() override;

  /// Measures on a task, and writes page, table and plots into a folder.
  void measureInto(const QString& folder);

 private:
  void askFolder();
  void showNote(const QString& note);

  SessionModel* m_model;
  Task* m_task;
  QPushButton* m_open;
  QLabel* m_note;
  QString m_page;  ///< the last one written
};

}  // namespace hogelscope
