// SPDX-License-Identifier: BSD-3-Clause
// The states dock: the list of camera states with pictures of their views, its filter, and the
// commands of the States menu.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

class QToolButton;

namespace Ui {
class StateDock;
}

namespace hogelscope {

class FilteredRows;
class SceneController;
class SessionModel;
class StateCommands;
class StateRows;

/// Imports the states of session documents dropped onto it; its own rows can be dragged to another
/// place.
class StateDock : public QWidget {
  Q_OBJECT

 public:
  /// `scene` renders the pictures of the rows in sight.
  StateDock(SessionModel* model, StateCommands* commands, SceneController* scene,
            QWidget* parent = nullptr);
  ~StateDock() override;

  /// Opens the editor of the current state's name.
  void editName();
  /// Shows the PSNR in dB of each state; empty: none. Infinite: identical; NaN: no view. A stale
  /// one is grey and marked.
  void showPsnr(const std::vector<double>& dB, const std::vector<bool>& isStale);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  /// Asks for the pictures of the rows that are painted.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fillHeader();
  void connectModel();
  template <class Change>
  void follow(Change change);
  void showCurrent();
  void emitSelection();
  [[nodiscard]] std::size_t stateAt(const QModelIndex& index) const;

  std::unique_ptr<Ui::StateDock> m_ui;
  SessionModel* m_model;
  StateCommands* m_commands;
  SceneController* m_scene;
  StateRows* m_rows;
  FilteredRows* m_shown;
  std::vector<QToolButton*> m_buttons;  ///< those that hide where there is no room
  bool m_isFollowing = false;           ///< the list follows the session, not the user
};

}  // namespace hogelscope
