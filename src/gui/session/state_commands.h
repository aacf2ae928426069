// SPDX-License-Identifier: BSD-3-Clause
// The States menu: changes of the list of camera states (core/cameras/state_list_edits.h).
#pragma once

#include <QObject>
#include <vector>

#include "core/optics/session.h"
#include "gui/widgets/command.h"

namespace hogelscope {

class SessionModel;

class StateCommands : public QObject {
  Q_OBJECT

 public:
  StateCommands(QMenu* menu, SessionModel* model, QObject* parent);

  /// Returns the actions in the menu's order.
  [[nodiscard]] const std::vector<QAction*>& actions() const { return m_actions; }

  [[nodiscard]] QMenu* menu() const { return m_menu; }

  /// Renames a state. Returns true on success.
  bool rename(std::size_t index, const QString& name);
  /// Moves the states at `indices` before the one now at `before`; the current one stays current.
  bool move(const std::vector<std::size_t>& indices, std::size_t before);
  /// Appends a file's states to the session's.
  bool mergeStatesOf(const QString& file);
  /// Adds the marked states to another document.
  bool appendStatesTo(const QString& file);
  /// Writes a document with the session's light field and the marked states only.
  bool saveStatesAs(const QString& file);

 Q_SIGNALS:
  void nameAsked();  ///< requests the editor of the current state's name
  void done(const QString& line);
  void failed(const QString& line);

 private:
  void addListEntries();
  void addFileEntries();
  template <class Slot>
  void add(const CommandText& text, Slot slot);
  void change(const QString& name, std::size_t (*action)(Session&, std::size_t));
  void remove();
  [[nodiscard]] std::vector<CameraState> markedStates() const;

  QMenu* m_menu;
  SessionModel* m_model;
  std::vector<QAction*> m_actions;
};

}  // namespace hogelscope
