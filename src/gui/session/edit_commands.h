// SPDX-License-Identifier: BSD-3-Clause
// The Edit menu: undo, redo, the palette of commands and fields, and the dialog of keys.
#pragma once

#include <QMainWindow>
#include <QMenu>

namespace hogelscope {

class CommandPalette;
class KeyMap;
class SessionModel;

class EditCommands : public QObject {
  Q_OBJECT

 public:
  EditCommands(QMenu* menu, SessionModel* model, QMainWindow* window);

  /// Reads the keys. Call it when the window has all its actions.
  void readKeys();

 Q_SIGNALS:
  void failed(const QString& line);

 private:
  void showKeys();

  QMainWindow* m_window;
  KeyMap* m_keys = nullptr;
  CommandPalette* m_palette = nullptr;
};

}  // namespace hogelscope
