// SPDX-License-Identifier: BSD-3-Clause
// The dialog of all keys: searches commands, assigns other keys, shows conflicts.
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <QLineEdit>
#include <memory>

#include "gui/keys/key_map.h"

namespace Ui {
class KeyDialog;
}

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

/// Applies and saves changes at once.
class KeyDialog : public QDialog {
  Q_OBJECT

 public:
  KeyDialog(KeyMap* map, QWidget* parent);
  ~KeyDialog() override;

 private:
  enum Column { commandColumn, helpColumn, keyColumn, defaultColumn, conflictColumn, columnCount };

  void setWidths();
  void search(const QString& words);
  void refresh();
  void showRow(int row);
  void showChosen();
  [[nodiscard]] std::size_t chosen() const;
  [[nodiscard]] QString conflictText(int row) const;

  KeyMap* m_map;
  std::unique_ptr<Ui::KeyDialog> m_ui;
};

}  // namespace hogelscope
