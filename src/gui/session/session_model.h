// SPDX-License-Identifier: BSD-3-Clause
// The session shown and edited in the window, and its current state. Every edit has a name and can
// be undone: the whole session is kept before and after it; edits of one name within a second are
// one, and so are those of one drag.
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
  /// Returns the current state, or a default one if the session has none.
  [[nodiscard]] CameraState current() const;
  [[nodiscard]] QUndoStack* undoStack() { return &m_undo; }

  /// Opens a session. Throws InputError; the session is then unchanged.
  void open(const QString& file);
  /// Opens `copy`, left by a crash, as unsaved edits of `file`. Throws InputError; the session is
  /// then unchanged.
  void recover(const QString& copy, const QString& file);
  /// Opens a new session, which has no file yet.
  void openNew(const Session& session);
  /// Reads the session's file again, as an edit; the current state stays, by its name. Throws
  /// InputError; the session is then unchanged.
  void reload();
  /// Saves the session. Throws InputError; unsaved edits are then kept.
  void save(const QString& file);
  void setCurrentIndex(std::size_t index);
  /// Returns the selected states, ascending; the current one if none is selected.
  [[nodiscard]] std::vector<std::size_t> marked() const;
  void setMarked(std::vector<std::size_t> indices);

  /// Begins, or ends, a drag: the edits of one name meanwhile are undone together, however long it
  /// takes, and apart from earlier ones.
  void holdEdits(bool isHeld);
  /// Applies an edit; `name` appears in the Edit menu. Edits of one name that follow each other
  /// quickly, such as repeated keys, are undone together. Edits without changes are ignored. If
  /// `action` throws, the session is unchanged.
  void edit(const QString& name, const std::function<void(Session&)>& action);
  /// Sets the current state, field by field; the edit is named after the first changed field.
  void setCurrent(const CameraState& state);
  /// Applies `action` to the current state, and its changes to all marked states if the current one
  /// is among them; names stay different.
  void editMarked(const std::function<void(CameraState&)>& action);
  /// Sets the session, field by field; the edit is named after the first changed field.
  void setContent(const Session& content);
  /// Changes the list of states (core/cameras/state_list_edits.h); `action` returns the index of
  /// the new current state.
  void changeStates(const QString& name, const std::function<std::size_t(Session&)>& action);

 Q_SIGNALS:
  void opened();
  void saved();
  void currentChanged();  ///< another state is current
  void edited();          ///< values of states have changed
  void statesChanged();   ///< states have been added, removed, renamed or reordered
  void contentChanged();  ///< display, twin, light field, sampling or metrics have changed

 private:
  struct Content {
    Session session;
    std::size_t current = 0;
  };
  class Edit;

  void begin(const Session& session, const Session& saved, const QString& file);
  void push(const QString& name, Content after);
  void show(const Content& content);

  Session m_session;
  Session m_saved;
  QString m_file;
  std::size_t m_current = 0;
  std::vector<std::size_t> m_marked;
  QUndoStack m_undo;
  int m_drags = 0;
  int m_drag = 0;  ///< the number of the drag in progress; 0: none
};

}  // namespace hogelscope
