// SPDX-License-Identifier: BSD-3-Clause
// Messages of the window: lines in the status bar, and a list of all errors with their times.
// Errors are `failed` signals, which end here; those that keep the view from being right stand on
// it.
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;
class QPlainTextEdit;
class QToolButton;

namespace hogelscope {

/// Shows messages and errors. An error stays in the status bar, in red, until the user's next
/// action; messages that arrive meanwhile are shown after it.
class Messages : public QObject {
  Q_OBJECT

 public:
  /// Adds the error dock to the window and its button to the status bar, both hidden.
  explicit Messages(QMainWindow* window);

  void showMessage(const QString& line);
  void showError(const QString& line);
  /// Removes the error from the status bar after a user action, but not from the list.
  void dismiss();
  /// Resets the error count for a new session.
  void settle();
  [[nodiscard]] QDockWidget* dock() const { return m_dock; }

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void show();

  QMainWindow* m_window;
  QDockWidget* m_dock;
  QPlainTextEdit* m_list;
  QToolButton* m_button;
  QString m_line;
  QString m_error;  ///< empty once dismissed
  int m_count = 0;
};

}  // namespace hogelscope
