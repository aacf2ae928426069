// SPDX-License-Identifier: BSD-3-Clause
// The States menu: what is done to the list of camera states (core/states.h).
#pragma once

#include <QMenu>
#include <QObject>

namespace hogelscope {

class SessionModel;

class StateCommands : public QObject {
  Q_OBJECT

 public:
  StateCommands(QMenu* menu, SessionModel* model, QObject* parent);

  /// Loads a file's states behind the session's own. True if that went well.
  bool mergeStatesOf(const QString& file);
  /// Adds the current state to another document.
  bool appendStateTo(const QString& file);

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);

 private:
  void askName();
  void askStates();
  void askFile();
  template <class Action>
  bool guarded(Action action);

  QMenu* m_menu;
  SessionModel* m_model;
};

}  // namespace hogelscope
