// SPDX-License-Identifier: BSD-3-Clause
// A field that records the key pressed in it.
#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace hogelscope {

/// Replaces QKeySequenceEdit, which waits a second for a second key and traps Tab. Here Tab, Escape
/// and Return keep their meaning; Backspace and Delete remove the key.
class KeyField : public QLineEdit {
  Q_OBJECT

 public:
  explicit KeyField(QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Passes the new key; empty: removed.
  void keyPressed(const QKeySequence& key);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace hogelscope
