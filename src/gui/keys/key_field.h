// SPDX-License-Identifier: BSD-3-Clause
// A field that takes the key that is pressed in it.
#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace hogelscope {

/// Qt's own waits a second for a second key, and Tab cannot leave it. Here Tab, Escape and Return
/// keep their meaning; Backspace and Delete take the key away.
class KeyField : public QLineEdit {
  Q_OBJECT

 public:
  explicit KeyField(QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Empty: none any more.
  void keyPressed(const QKeySequence& key);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace hogelscope
