// SPDX-License-Identifier: BSD-3-Clause
#include "gui/session/state_commands.h"

#include <QFileInfo>
#include <algorithm>

#include "core/cameras/state_list_edits.h"
#include "gui/session/session_model.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "io/documents/session_file.h"

namespace hogelscope {

StateCommands::StateCommands(QMenu* menu, SessionModel* model, QObject* parent)
    : QObject(parent), m_menu(menu), m_model(model) {
  addListEntries();
  m_menu->addSeparator();
  addFileEntries();
}

/// The button's tooltip names the key.
template <class Slot>
void StateCommands::add(const CommandText& text, Slot slot) {
  QAction* action = addCommand(m_menu, text, this, slot);
  action->setToolTip(tr("%1 (%2)").arg(text.help, text.key.toString(QKeySequence::NativeText)));
  m_actions.push_back(action);
}

/// Adds the functions of core/cameras/state_list_edits.h, applied to the current state.
void StateCommands::addListEntries() {
  add({"addStateAction", tr("&New"), tr("A new state in front of the display"),
       Qt::CTRL | Qt::Key_N, tr("New")},
      [this] {
        change(tr("Add state"), [](Session& session, std::size_t) {
          return addState(session, inFrontOf(displayOf(session)));
        });
      });
  add({"duplicateAction", tr("&Duplicate"), tr("A copy of the current state behind it"),
       Qt::CTRL | Qt::Key_D, tr("Duplicate")},
      [this] { change(tr("Duplicate state"), duplicateState); });
  add({"renameAction", tr("&Rename"), tr("Edits the current state's name"), Qt::Key_F2,
       tr("Rename")},
      [this] { Q_EMIT nameAsked(); });
  add({"removeAction", tr("De&lete"), tr("Deletes the marked states"), Qt::CTRL | Qt::Key_Delete,
       tr("Delete")},
      [this] { remove(); });
  add({"moveUpAction", tr("Move &up"), tr("Moves the current state up"),
       Qt::CTRL | Qt::SHIFT | Qt::Key_Up, tr("Up")},
      [this] { change(tr("Move state"), moveStateUp); });
  add({"moveDownAction", tr("Move dow&n"), tr("Moves the current state down"),
       Qt::CTRL | Qt::SHIFT | Qt::Key_Down, tr("Down")},
      [this] { change(tr("Move state"), moveStateDown); });
}

void StateCommands::addFileEntries() {
  add({"loadStatesAction", tr("&Load states from file…"),
       tr("Adds another session's states behind these"), Qt::CTRL | Qt::SHIFT | Qt::Key_O,
       tr("Load…")},
      [this] {
        const QString file = chooseFile(m_menu, tr("Load states"), sessionFilter());
        if (!file.isEmpty()) mergeStatesOf(file);
      });
  add({"addToFileAction", tr("&Add to file…"),
       tr("Adds the marked states to another session's file"), Qt::CTRL | Qt::SHIFT | Qt::Key_A,
       tr("Add to…")},
      [this] {
        const QString file = chooseFile(m_menu, tr("Add states to session"), sessionFilter());
        if (!file.isEmpty()) appendStatesTo(file);
      });
  add({"saveStatesAction", tr("&Save to new file…"),
       tr("Writes a session of the marked states only"), Qt::CTRL | Qt::SHIFT | Qt::Key_E,
       tr("Save as…")},
      [this] {
        const QString file = chooseNewFile(m_menu, tr("Save states to new session"),
                                           QFileInfo(m_model->file()).fileName(), sessionFilter());
        if (!file.isEmpty()) saveStatesAs(file);
      });
}

std::vector<CameraState> StateCommands::markedStates() const {
  std::vector<CameraState> states;
  for (const std::size_t index : m_model->marked())
    states.push_back(m_model->session().cameras.at(index));
  return states;
}

void StateCommands::change(const QString& name, std::size_t (*action)(Session&, std::size_t)) {
  guarded(this, [&] {
    m_model->changeStates(
        name, [&](Session& session) { return action(session, m_model->currentIndex()); });
  });
}

void StateCommands::remove() {
  guarded(this, [&] {
    const auto count = int(m_model->marked().size());
    m_model->changeStates(tr("Delete %n states", "", count), [this](Session& session) {
      const std::size_t first = m_model->marked().front();
      removeStates(session, m_model->marked());
      return std::min(first, session.cameras.size() - 1);
    });
  });
}

bool StateCommands::rename(std::size_t index, const QString& name) {
  return guarded(this, [&] {
    m_model->changeStates(tr("Rename state"), [&](Session& session) {
      renameState(session, index, name.toStdString());
      return m_model->currentIndex();
    });
  });
}

bool StateCommands::move(const std::vector<std::size_t>& indices, std::size_t before) {
  return guarded(this, [&] {
    m_model->changeStates(tr("Move %n states", "", int(indices.size())), [&](Session& session) {
      const std::string current = session.cameras.at(m_model->currentIndex()).camera.name;
      moveStates(session, indices, before);
      return *stateNamed(session, current);
    });
  });
}

bool StateCommands::mergeStatesOf(const QString& file) {
  return guarded(this, [&] {
    const std::vector<CameraState> states = loadStates(file.toStdString());
    m_model->changeStates(tr("Load states"), [&](Session& session) {
      const std::size_t first = session.cameras.size();
      mergeStates(session, states);
      return first;
    });
  });
}

bool StateCommands::appendStatesTo(const QString& file) {
  return guarded(this, [&] {
    const std::vector<CameraState> states = markedStates();
    appendStates(file.toStdString(), states);
    Q_EMIT done(tr("Added %n states to %1", "", int(states.size())).arg(file));
  });
}

bool StateCommands::saveStatesAs(const QString& file) {
  return guarded(this, [&] {
    Session session = m_model->session();
    session.cameras = markedStates();
    check(session);
    saveSession(file.toStdString(), session);
    Q_EMIT done(tr("Saved %1").arg(file));
  });
}

}  // namespace hogelscope
