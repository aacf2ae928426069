// SPDX-License-Identifier: BSD-3-Clause
// The session that the window shows and edits, and its current state. Every edit has a name and can
// be taken back.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <vector>

#include "core/optics/session.h"

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
  [[nodiscard]] QUndoStack* undoStack() { return &m_undo; }

  /// Throws InputError; the session stays as it was.
  void open(const QString& file);
  /// Opens `copy`, which a crash left behind, as unsaved edits of `file`. Throws InputError; the
  /// session stays as it was.
  void recover(const QString& copy, const QString& file);
  /// A new session, which has no file yet.
  void openNew(const Session& session);
  /// Throws InputError; unsaved edits stay.
  void save(const QString& file);
  void setCurrentIndex(std::size_t index);
  /// The selected states, ascending; the current one alone where there are none.
  [[nodiscard]] std::vector<std::size_t> marked() const;
  void setMarked(std::vector<std::size_t> indices);

  /// One edit; its name is what the Edit menu says. Edits of one name that follow each other
  /// quickly, as a slider's do, are taken back together. One that changes nothing is none. What
  /// `action` throws leaves the session as it was.
  void edit(const QString& name, const std::function<void(Session&)>& action);
  /// The current state, field by field; the name is that of the first field that changes.
  void setCurrent(const CameraState& state);
  /// What `action` changes in the current state it does to all marked ones, if that is one of them;
  /// names stay different.
  void editMarked(const std::function<void(CameraState&)>& action);
  /// Display, light field and sampling, likewise.
  void setContent(const Session& content);
  /// Does something to the list of states (core/states.h); the one at the index that `action`
  /// returns becomes current.
  void changeStates(const QString& name, const std::function<std::size_t(Session&)>& action);

 Q_SIGNALS:
  void opened();
  void saved();
  void currentChanged();  ///< another state is current
  void edited();          ///< states have other values
  void statesChanged();   ///< there are other states, other names, or their order is another
  void contentChanged();  ///< display, light field or sampling have other values

 private:
  struct Content {
    Session session;
    std::size_t current = 0;
  };
  class Edit;

  void push(const QString& name, Content after);
  void show(const Content& content);

  Session m_session;
  Session m_saved;
  QString m_file;
  std::size_t m_current = 0;
  std::vector<std::size_t> m_marked;
  QUndoStack m_undo;
};

}  // namespace hogelscope
