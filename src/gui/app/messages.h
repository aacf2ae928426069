// SPDX-License-Identifier: BSD-3-Clause
// What the window says: lines in the status bar, and every error, with its time, in one list.
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;
class QPlainTextEdit;
class QToolButton;

namespace hogelscope {

/// An error stands in the status bar, in red, until the user's next action; what is said meanwhile
/// comes after it.
class Messages : public QObject {
  Q_OBJECT

 public:
  /// Adds the dock of errors to the window and its button to the status bar, both hidden.
  explicit Messages(QMainWindow* window);

  void showMessage(const QString& line);
  void showError(const QString& line);
  /// The user has done something else: the error leaves the status bar, not the list.
  void dismiss();
  /// The session is another one now: what was wrong before it is no longer counted.
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
