// SPDX-License-Identifier: BSD-3-Clause
// The palette of all commands and fields of the window: a few letters find them, Return does the
// command or goes to the field.
#pragma once

#include <QFrame>
#include <QPointer>
#include <memory>
#include <vector>

class QAction;
class QMainWindow;
class QToolButton;

namespace Ui {
class CommandPalette;
}

namespace hogelscope {

class KeyMap;

/// A part of the window that lies on it at the top. It lists the commands of the key map and the
/// rows of all parameter forms of the window.
class CommandPalette : public QFrame {
  Q_OBJECT

 public:
  CommandPalette(KeyMap* map, QMainWindow* window);
  ~CommandPalette() override;

  /// Shows the palette, or hides it if it is shown.
  void toggle();
  /// Creates a button for the top bar that triggers `action` and shows its key.
  static QToolButton* makeButton(QAction* action);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Entry {
    QString id;                ///< the command's object name, or group and label of a field
    QString title;             ///< of the command, or label of the field
    QString path;              ///< the menu, or the group of the field
    QString right;             ///< key, or value
    QPointer<QAction> action;  ///< null: a field, or none is enabled
    QPointer<QWidget> editor;
  };

  void collect();
  void search(const QString& text);
  void choose();
  void leave();

  KeyMap* m_map;
  QMainWindow* m_window;
  std::unique_ptr<Ui::CommandPalette> m_ui;
  std::vector<Entry> m_entries;
  QPointer<QWidget> m_before;  ///< what had the focus
};

}  // namespace hogelscope
