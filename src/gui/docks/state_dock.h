// SPDX-License-Identifier: BSD-3-Clause
// The states dock: the list of camera states and the commands of the States menu.
#pragma once

#include <QListWidget>
#include <QWidget>
#include <vector>

class QListWidgetItem;

namespace hogelscope {

class SessionModel;
class StateCommands;

/// The list of camera states. Dragged rows emit their destination and do not move by themselves.
class StateListWidget : public QListWidget {
  Q_OBJECT

 public:
  explicit StateListWidget(QWidget* parent = nullptr);

  /// Returns the size of six rows.
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  /// Emits the dragged rows in ascending order; `before` is a row index before the move, or the row
  /// count for the end.
  void rowsDropped(const std::vector<std::size_t>& rows, std::size_t before);

 protected:
  void startDrag(Qt::DropActions actions) override;
  void dropEvent(QDropEvent* event) override;

 private:
  [[nodiscard]] int rowBelow(const QDropEvent& event) const;
};

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
