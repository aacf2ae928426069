// SPDX-License-Identifier: BSD-3-Clause
// The states dock: the list of camera states, and what the States menu does to them.
#pragma once

#include <QWidget>

class QListWidgetItem;

namespace hogelscope {

class SessionModel;
class StateCommands;
class StateListWidget;

/// Session documents that are dropped onto it give it their states; its own rows are dragged to
/// another place.
class StateDock : public QWidget {
  Q_OBJECT

 public:
  StateDock(SessionModel* model, StateCommands* commands, QWidget* parent = nullptr);

  /// Opens the current state's name for editing.
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
