// SPDX-License-Identifier: BSD-3-Clause
// The session that the window shows and edits, and its current state.
#pragma once

#include <QObject>
#include <QString>

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

 Q_SIGNALS:
  void opened();
  void saved();
  void currentChanged();  ///< another state is current
  void edited();          ///< the current state has other values

 private:
  Session m_session;
  Session m_saved;
  QString m_file;
  std::size_t m_current = 0;
};

}  // namespace hogelscope
