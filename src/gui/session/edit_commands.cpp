// SPDX-License-Identifier: BSD-3-Clause
#include "gui/session/edit_commands.h"

#include "gui/keys/command_palette.h"
#include "gui/keys/field_guards.h"
#include "gui/keys/key_dialog.h"
#include "gui/keys/key_map.h"
#include "gui/session/session_model.h"
#include "gui/widgets/command.h"

namespace hogelscope {

EditCommands::EditCommands(QMenu* menu, SessionModel* model, QMainWindow* window)
    : QObject(window), m_window(window) {
  guardFields(this);
  const auto add = [menu](QAction* action, const char* name, const QString& help,
                          const QKeySequence& key) {
    action->setObjectName(name);
    action->setToolTip(help);
    action->setShortcut(key);
    menu->addAction(action);
  };
  add(model->undoStack()->createUndoAction(this, tr("&Undo")), "undoAction",
      tr("Takes the last edit of the session back"), Qt::CTRL | Qt::Key_Z);
  add(model->undoStack()->createRedoAction(this, tr("&Redo")), "redoAction",
      tr("Does again what was taken back"), Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
  menu->addSeparator();
  addCommand(menu,
             {"commandPaletteAction", tr("&Commands and fields…"),
              tr("Finds a command or a field by a few letters, and does or edits it"),
              Qt::CTRL | Qt::Key_P},
             this, [this] { m_palette->toggle(); });
  addCommand(menu,
             {"keysAction", tr("&Keys…"),
              tr("All commands and their keys, to search and to change"), Qt::CTRL | Qt::Key_K},
             this, &EditCommands::showKeys);
}

void EditCommands::readKeys() {
  m_keys = new KeyMap(m_window);
  connect(m_keys, &KeyMap::failed, this, &EditCommands::failed);
  m_keys->load();
  m_palette = new CommandPalette(m_keys, m_window);
}

void EditCommands::showKeys() {
  auto* keys = m_window->findChild<KeyDialog*>();
  if (keys == nullptr) keys = new KeyDialog(m_keys, m_window);
  keys->show();
  keys->raise();
  keys->activateWindow();
}

}  // namespace hogelscope
