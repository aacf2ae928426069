// SPDX-License-Identifier: BSD-3-Clause
// The session that the window shows and edits.
#include "gui/session_model.h"

#include "io/session_file.h"

namespace hogelscope {

CameraState SessionModel::current() const {
  return m_current < m_session.cameras.size() ? m_session.cameras[m_current] : CameraState{};
}

void SessionModel::open(const QString& file) {
  m_session = loadSession(file.toStdString());
  m_saved = m_session;
  m_file = file;
  m_current = 0;
  Q_EMIT opened();
}

void SessionModel::save(const QString& file) {
  check(m_session);
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

void SessionModel::changeStates(const std::function<std::size_t(Session&)>& action) {
  Session changed = m_session;
  const std::size_t current = action(changed);
  m_session = std::move(changed);
  m_current = current;
  Q_EMIT statesChanged();
}

void SessionModel::setCurrent(const CameraState& state) {
  if (m_current >= m_session.cameras.size() || m_session.cameras[m_current] == state) return;
  m_session.cameras[m_current] = state;
  Q_EMIT edited();
}

}  // namespace hogelscope
