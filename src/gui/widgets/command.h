// SPDX-License-Identifier: BSD-3-Clause
// Commands of the window: actions of its menus, which have a name, a tooltip and a key.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMenu>

namespace hogelscope {

/// The texts of a command.
struct CommandText {
  QString name;  ///< object name, which is also its name in the file of keys
  QString title;
  QString help;
  QKeySequence key;
  QString buttonText = {};  ///< short title on buttons; empty: `title`
};

/// Appends a command to a menu, which owns it. `slot` is called on `context` when it is triggered.
template <class Context, class Slot>
QAction* addCommand(QMenu* menu, const CommandText& text, const Context* context, Slot slot) {
  menu->setToolTipsVisible(true);
  QAction* action = menu->addAction(text.title, context, slot);
  action->setObjectName(text.name);
  action->setToolTip(text.help);
  action->setShortcut(text.key);
  if (!text.buttonText.isEmpty()) action->setIconText(text.buttonText);
  return action;
}

/// Appends a command that is on or off. `slot` is called with each new state.
template <class Context, class Slot>
QAction* addSwitch(QMenu* menu, const CommandText& text, bool isOn, const Context* context,
                   Slot slot) {
  QAction* action = addCommand(menu, text, context, [] {});
  action->setCheckable(true);
  action->setChecked(isOn);
  QObject::connect(action, &QAction::toggled, context, slot);
  return action;
}

}  // namespace hogelscope
