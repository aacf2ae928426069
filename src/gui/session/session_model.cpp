// SPDX-License-Identifier: BSD-3-Clause
#include "gui/session/session_model.h"

#include <QElapsedTimer>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "core/cameras/state_list_edits.h"
#include "io/documents/edit_name.h"
#include "io/documents/session_file.h"
#include "io/files/files_in_use.h"

namespace hogelscope {

/// An edit as the whole session before and after, which is small compared to the light field.
class SessionModel::Edit : public QUndoCommand {
 public:
  Edit(SessionModel& model, const QString& name, Content before, Content after)
      : QUndoCommand(name),
        m_model(model),
        m_before(std::move(before)),
        m_after(std::move(after)),
        m_drag(model.m_drag) {
    m_time.start();
  }

  void undo() override { m_model.show(m_before); }
  void redo() override { m_model.show(m_after); }
  [[nodiscard]] int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* next) override {
    constexpr qint64 quickly = 1000;  // milliseconds
    const auto* other = static_cast<const Edit*>(next);
    if (other->text() != text() || other->m_drag != m_drag ||
        (m_drag == 0 && m_time.hasExpired(quickly)) ||
        other->m_before.current != m_before.current ||
        other->m_after.session.cameras.size() != m_before.session.cameras.size())
      return false;
    m_after = other->m_after;
    m_time.start();
    return true;
  }

 private:
  SessionModel& m_model;
  Content m_before;
  Content m_after;
  int m_drag;  ///< in which it was made
  QElapsedTimer m_time;
};

CameraState SessionModel::current() const {
  return m_current < m_session.cameras.size() ? m_session.cameras[m_current] : CameraState{};
}

void SessionModel::open(const QString& file) {
  const Session session = loadSession(file.toStdString());
  begin(session, session, file);
}

void SessionModel::recover(const QString& copy, const QString& file) {
  // The file may differ from what the user saved last.
  begin(loadSession(copy.toStdString()), {}, file);
}

void SessionModel::openNew(const Session& session) {
  begin(session, session, {});  // no edits yet
}

void SessionModel::begin(const Session& session, const Session& saved, const QString& file) {
  m_session = session;
  m_saved = saved;
  m_file = file;
  m_current = 0;
  m_undo.clear();
  Q_EMIT opened();
}

void SessionModel::reload() {
  const Session session = loadSession(m_file.toStdString());
  m_saved = session;
  push(tr("Reload"), {session, stateNamed(session, current().camera.name).value_or(0)});
  Q_EMIT saved();
}

void SessionModel::save(const QString& file) {
  check(m_session);
  const FilesInUse inUse(
      sessionFiles(m_session));  // those of its light field are, while it is shown
  saveSession(file.toStdString(), m_session);
  m_saved = m_session;
  m_file = file;
  Q_EMIT saved();
}

void SessionModel::setCurrentIndex(std::size_t index) {
  if (index == m_current || index >= m_session.cameras.size()) return;
  m_current = index;
  Q_EMIT currentChanged();
}

std::vector<std::size_t> SessionModel::marked() const {
  return m_marked.empty() ? std::vector{m_current} : m_marked;
}

void SessionModel::setMarked(std::vector<std::size_t> indices) {
  std::ranges::sort(indices);
  m_marked = std::move(indices);
}

void SessionModel::push(const QString& name, Content after) {
  if (after.session == m_session && after.current == m_current) return;
  m_undo.push(new Edit(*this, name, {m_session, m_current}, std::move(after)));
}

void SessionModel::show(const Content& content) {
  const Session before = std::move(m_session);
  m_session = content.session;
  const bool isOther = std::exchange(m_current, content.current) != content.current;
  if (before.display != m_session.display || before.lightField != m_session.lightField ||
      before.sampling != m_session.sampling || before.twin != m_session.twin ||
      before.metrics != m_session.metrics)
    Q_EMIT contentChanged();
  const auto nameOf = [](const CameraState& state) { return state.camera.name; };
  if (!std::ranges::equal(before.cameras, m_session.cameras, {}, nameOf, nameOf))
    Q_EMIT statesChanged();
  else if (before.cameras != m_session.cameras)
    Q_EMIT edited();
  else if (isOther)
    Q_EMIT currentChanged();
}

void SessionModel::holdEdits(bool isHeld) {
  m_drag = isHeld ? ++m_drags : 0;
}

void SessionModel::edit(const QString& name, const std::function<void(Session&)>& action) {
  Content after{m_session, m_current};
  action(after.session);
  push(name, std::move(after));
}

void SessionModel::setCurrent(const CameraState& state) {
  if (m_current >= m_session.cameras.size() || state == current()) return;
  const std::string field = changedField(current(), state);
  edit(tr("Change %1").arg(QString::fromStdString(field)),
       [&](Session& session) { session.cameras[m_current] = state; });
}

void SessionModel::editMarked(const std::function<void(CameraState&)>& action) {
  CameraState state = current();
  action(state);
  const std::vector<std::size_t> all = marked();
  if (all.size() == 1 || !std::ranges::binary_search(all, m_current)) return setCurrent(state);
  if (state == current()) return;
  const std::string field = changedField(current(), state);
  const QString name =
      tr("Change %1 of %n states", "", int(all.size())).arg(QString::fromStdString(field));
  edit(name, [&](Session& session) {
    for (const std::size_t index : all) {
      const std::string own = session.cameras.at(index).camera.name;
      action(session.cameras[index]);
      if (index != m_current) session.cameras[index].camera.name = own;
    }
  });
}

void SessionModel::setContent(const Session& content) {
  if (content == m_session) return;
  const std::string field = changedField(m_session, content);
  push(tr("Change %1").arg(QString::fromStdString(field)), {content, m_current});
}

void SessionModel::changeStates(const QString& name,
                                const std::function<std::size_t(Session&)>& action) {
  Content after{m_session, m_current};
  after.current = action(after.session);
  push(name, std::move(after));
}

}  // namespace hogelscope
