// SPDX-License-Identifier: BSD-3-Clause
// The session that the window shows and edits, and its current state.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "core/session.h"

namespace hogelscope {

class SessionModel : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  [[nodiscard]] const Session& session() const { return m_session; }
  [[nodiscard]] const QString& file() const { return m_file; }
  [[nodiscard]] bool isModified() const { return m_session != m_saved; }
  [[nodiscard]] std::size_t currentIndex() const { return m_current; }
  /// A default state where the session has none.
  [[nodiscard]] CameraState current() const;

  /// Throws InputError; the session stays as it was.
  void open(const QString& file);
  /// Throws InputError; unsaved edits stay.
  void save(const QString& file);
  void setCurrentIndex(std::size_t index);
  /// An equal state changes nothing.
  void setCurrent(const CameraState& state);
  /// Does something to the list of states (core/states.h); the one at the index that `action`
  /// returns becomes current. What it throws leaves the session as it was.
  void changeStates(const std::function<std::size_t(Session&)>& action);

 Q_SIGNALS:
  void opened();
  void saved();
  void currentChanged();  ///< another state is current
  void edited();          ///< the current state has other values
  void statesChanged();   ///< there are other states, or their order is another

 private:
  Session m_session;
  Session m_saved;
  QString m_file;
  std::size_t m_current = 0;
};

}  // namespace hogelscope
