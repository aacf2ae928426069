// SPDX-License-Identifier: BSD-3-Clause
// A line above a view that stays until it is closed, with a button for what can be done about it.
#pragma once

#include <QFrame>

class QAction;
class QLabel;

namespace hogelscope {

class NoteBar : public QFrame {
  Q_OBJECT

 public:
  /// `cure` is offered beside each line.
  explicit NoteBar(QAction* cure, QWidget* parent = nullptr);

  /// Shows a line in place of the one before.
  void say(const QString& line);
  [[nodiscard]] QString line() const;

 private:
  QLabel* m_line;
};

}  // namespace hogelscope
