// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/key_map.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QSet>
#include <QStandardPaths>
#include <QToolBar>
#include <algorithm>

#include "gui/widgets/guarded.h"
#include "io/documents/key_map_file.h"

namespace hogelscope {

namespace {

std::string fileName() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation);
  return (folder + "/keys.json").toStdString();
}

/// Returns a menu's text without mnemonic and dots.
QString withoutMnemonic(QString text) {
  return text.remove('&').remove(QStringLiteral("…"));
}

template <class Widget>
Widget* holderOf(const QAction* action) {
  for (QObject* object : action->associatedObjects())
    if (auto* widget = qobject_cast<Widget*>(object)) return widget;
  return nullptr;
}

/// Returns the menu's path, such as "Camera, Large steps", or the name of the action's widget.
QString sectionOf(const QAction* action) {
  if (const auto* menu = holderOf<QMenu>(action)) {
    const QString above = sectionOf(menu->menuAction());
    return above.isEmpty() ? withoutMnemonic(menu->title())
                           : above + ", " + withoutMnemonic(menu->title());
  }
  const auto* widget = holderOf<QWidget>(action);
  if (widget == nullptr || widget->accessibleName().isEmpty()) return {};
  return KeyMap::tr("%1 that has the focus").arg(widget->accessibleName());
}

/// Returns the widgets whose focus a command needs; empty if it works anywhere in the window.
QSet<QWidget*> focusWidgetsOf(const QList<QPointer<QAction>>& actions) {
  QSet<QWidget*> widgets;
  for (const QPointer<QAction>& action : actions) {
    if (action == nullptr || action->shortcutContext() != Qt::WidgetShortcut) continue;
    for (QObject* object : action->associatedObjects())
      if (auto* widget = qobject_cast<QWidget*>(object);
          widget != nullptr && qobject_cast<QMenu*>(object) == nullptr)
        widgets.insert(widget);
  }
  return widgets;
}

bool isCommand(const QAction* action) {
  const QString name = action->objectName();
  return !name.isEmpty() && !name.startsWith('_') && !name.startsWith("qt_") &&
         !action->isSeparator() && action->menu() == nullptr;
}

bool isKey(const QKeySequence& key, const std::string& text) {
  if (text.empty()) return true;
  for (int k = 0; k < key.count(); ++k)
    if (key[uint(k)].key() == Qt::Key_unknown) return false;
  return !key.isEmpty();
}

}  // namespace

KeyMap::KeyMap(QMainWindow* window) : QObject(window) {
  const auto nameToggle = [](const QWidget* part, QAction* toggle, const QString& help) {
    toggle->setObjectName(part->objectName() + "Action");
    toggle->setToolTip(help.arg(part->windowTitle()));
  };
  for (auto* dock : window->findChildren<QDockWidget*>())
    nameToggle(dock, dock->toggleViewAction(), tr("Shows, brings to the front or hides: %1"));
  for (auto* bar : window->findChildren<QToolBar*>())
    nameToggle(bar, bar->toggleViewAction(), tr("Shows or hides: %1"));
  for (QAction* action : window->findChildren<QAction*>())
    if (isCommand(action)) addAction(action);
  std::ranges::stable_sort(m_commands, {}, &Command::section);
}

void KeyMap::addAction(QAction* action) {
  const auto same = std::ranges::find(m_commands, action->objectName(), &Command::name);
  if (same != m_commands.end()) {
    same->actions.append(action);
    return;
  }
  const QString title = withoutMnemonic(action->text());
  const QString help = action->toolTip();
  m_commands.push_back({action->objectName(),
                        sectionOf(action),
                        title,
                        help == title ? QString() : help,
                        {action},
                        action->shortcuts(),
                        action->shortcuts()});
}

/// Whether the commands never compete: each needs the focus of a widget that the other does not
/// use.
bool KeyMap::areApart(const Command& a, const Command& b) {
  const QSet<QWidget*> of = focusWidgetsOf(a.actions);
  const QSet<QWidget*> others = focusWidgetsOf(b.actions);
  return !of.isEmpty() && !others.isEmpty() && !of.intersects(others);
}

std::vector<std::size_t> KeyMap::conflictsOf(std::size_t command) const {
  std::vector<std::size_t> others;
  const auto isUsed = [&](const QKeySequence& key) {
    return m_commands[command].keys.contains(key);
  };
  for (std::size_t k = 0; k < m_commands.size(); ++k)
    if (k != command && std::ranges::any_of(m_commands[k].keys, isUsed) &&
        !areApart(m_commands[k], m_commands[command]))
      others.push_back(k);
  return others;
}

void KeyMap::assign(Command& command, const QList<QKeySequence>& keys) {
  command.keys = keys;
  for (const QPointer<QAction>& action : command.actions)
    if (action != nullptr) action->setShortcuts(keys);
}

void KeyMap::setKey(std::size_t command, const QKeySequence& key) {
  assign(m_commands.at(command), key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
  finish();
}

void KeyMap::reset(std::size_t command) {
  assign(m_commands.at(command), m_commands.at(command).defaults);
  finish();
}

void KeyMap::resetAll() {
  for (Command& command : m_commands) assign(command, command.defaults);
  finish();
}

/// Emits changed() and saves the keys.
void KeyMap::finish() {
  Q_EMIT changed();
  KeyTexts texts;
  for (const Command& command : m_commands)
    if (command.keys != command.defaults) {
      const QKeySequence key = command.keys.value(0);
      texts[command.name.toStdString()] = key.toString(QKeySequence::PortableText).toStdString();
    }
  guarded(this, [&] { saveKeyTexts(fileName(), texts); });
}

void KeyMap::load() {
  if (!QFileInfo::exists(QString::fromStdString(fileName()))) return;
  guarded(this, [&] {
    for (const auto& [name, text] : loadKeyTexts(fileName())) {
      const QString wanted = QString::fromStdString(name);
      const auto command = std::ranges::find(m_commands, wanted, &Command::name);
      if (command == m_commands.end()) continue;  // from another version
      const auto key =
          QKeySequence::fromString(QString::fromStdString(text), QKeySequence::PortableText);
      if (isKey(key, text))
        assign(*command, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
      else
        Q_EMIT failed(
            tr("%1: keys.%2: \"%3\" is not a key")
                .arg(QString::fromStdString(fileName()), wanted, QString::fromStdString(text)));
    }
  });
  Q_EMIT changed();
}

}  // namespace hogelscope
