// SPDX-License-Identifier: BSD-3-Clause
// The States menu.
#include "gui/state_commands.h"

#include <QFileDialog>
#include <QInputDialog>

#include "core/states.h"
#include "gui/session_model.h"
#include "io/session_file.h"

namespace hogelscope {

template <class Action>
bool StateCommands::guarded(Action action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return false;
  }
}

/// What core/states.h does, on the current state.
StateCommands::StateCommands(QMenu* menu, SessionModel* model, QObject* parent)
    : QObject(parent), m_menu(menu), m_model(model) {
  m_menu->setToolTipsVisible(true);
  const auto add = [this](const char* name, const QString& title, const QString& help,
                          const QKeySequence& key, auto action) {
    auto* entry = m_menu->addAction(title, this, action);
    entry->setObjectName(name);
    entry->setToolTip(help);
    entry->setShortcut(key);
  };
  const auto change = [this](const QString& name, std::size_t (*action)(Session&, std::size_t)) {
    return [this, name, action] {
      guarded([&] {
        m_model->changeStates(
            name, [&](Session& session) { return action(session, m_model->currentIndex()); });
      });
    };
  };
  add("duplicateAction", tr("&Duplicate"), tr("Copies the current state"), Qt::CTRL | Qt::Key_D,
      change(tr("Duplicate state"), duplicateState));
  add("renameAction", tr("&Rename…"), tr("Gives the current state another name"), Qt::Key_F2,
      [this] { askName(); });
  add("removeAction", tr("De&lete"), tr("Takes the current state out of the session"),
      Qt::CTRL | Qt::Key_Delete,
      change(tr("Delete state"), [](Session& session, std::size_t index) {
        removeState(session, index);
        return std::min(index, session.cameras.size() - 1);
      }));
  add("moveUpAction", tr("Move &up"), tr("Swaps the current state with the one before it"),
      Qt::CTRL | Qt::SHIFT | Qt::Key_Up,
      change(tr("Move state"), [](Session& session, std::size_t index) {
        const std::size_t to = index > 0 ? index - 1 : 0;
        moveState(session, index, to);
        return to;
      }));
  add("moveDownAction", tr("Move dow&n"), tr("Swaps the current state with the one after it"),
      Qt::CTRL | Qt::SHIFT | Qt::Key_Down,
      change(tr("Move state"), [](Session& session, std::size_t index) {
        const std::size_t to = std::min(index + 1, session.cameras.size() - 1);
        moveState(session, index, to);
        return to;
      }));
  m_menu->addSeparator();
  add("loadStatesAction", tr("&Load states from file…"),
      tr("Adds the states of another session behind this one's"), Qt::CTRL | Qt::SHIFT | Qt::Key_O,
      [this] { askStates(); });
  add("addToFileAction", tr("&Add this state to file…"),
      tr("Saves the current state as one more of another session's file"),
      Qt::CTRL | Qt::SHIFT | Qt::Key_A, [this] { askFile(); });
}

void StateCommands::askName() {
  bool isGiven = false;
  const QString name = QInputDialog::getText(
      m_menu, tr("Rename state"), tr("Name, also of its picture's file:"), QLineEdit::Normal,
      QString::fromStdString(m_model->current().camera.name), &isGiven);
  if (!isGiven) return;
  guarded([&] {
    m_model->changeStates(tr("Rename state"), [&](Session& session) {
      renameState(session, m_model->currentIndex(), name.toStdString());
      return m_model->currentIndex();
    });
  });
}

void StateCommands::askStates() {
  const QString file = QFileDialog::getOpenFileName(m_menu, tr("Load states"), m_model->file(),
                                                    tr("Sessions (*.json)"));
  if (!file.isEmpty()) mergeStatesOf(file);
}

bool StateCommands::mergeStatesOf(const QString& file) {
  return guarded([&] {
    const std::vector<CameraState> states = loadStates(file.toStdString());
    m_model->changeStates(tr("Load states"), [&](Session& session) {
      const std::size_t first = session.cameras.size();
      mergeStates(session, states);
      return first;
    });
  });
}

void StateCommands::askFile() {
  const QString file = QFileDialog::getOpenFileName(m_menu, tr("Add state to session"),
                                                    m_model->file(), tr("Sessions (*.json)"));
  if (!file.isEmpty()) appendStateTo(file);
}

bool StateCommands::appendStateTo(const QString& file) {
  return guarded([&] {
    appendStates(file.toStdString(), {m_model->current()});
    Q_EMIT done(tr("Added to %1").arg(file));
  });
}

}  // namespace hogelscope
