// SPDX-License-Identifier: BSD-3-Clause
// The states dock: the list of camera states and the commands of the States menu.
#pragma once

#include <QWidget>

class QListWidgetItem;

namespace hogelscope {

class SessionModel;
class StateCommands;
class StateListWidget;

/// Imports the states of session documents dropped onto it; its own rows can be dragged to another
/// place.
class StateDock : public QWidget {
  Q_OBJECT

 public:
  StateDock(SessionModel* model, StateCommands* commands, QWidget* parent = nullptr);

  /// Opens the editor of the current state's name.
  void editName();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makeButtons();
  void fill();
  void showCurrent();
  void emitSelection();
  void rename(const QListWidgetItem* item);

  SessionModel* m_model;
  StateCommands* m_commands;
  StateListWidget* m_list;
};

}  // namespace hogelscope
