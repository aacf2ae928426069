// SPDX-License-Identifier: BSD-3-Clause
// The layout of the window and its docks: the home page, workspaces for tasks, one view alone;
// saved between runs. Also defines the effect of a dock's key.
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QRect>
#include <vector>

class QAction;
class QActionGroup;
class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace hogelscope {

class Properties;
class Section;

/// Returns the window's frame, shrunk and moved only as far as needed to fit the screen.
QRect fitted(QRect frame, const QRect& screen);

class WindowLayout : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QWidget* home;
    QWidget* view;  ///< the simulated view with its bars
    QDockWidget *scene, *states, *properties, *measure, *tradeoff, *report;
    Properties* sections;
  };

  /// Places the docks, adds the commands to the View menu and shows the home page. A double click
  /// on one of `views` (simulated view, scene) shows it alone. `window` owns the layout.
  WindowLayout(QMainWindow* window, QMenu* menu, const Parts& parts,
               const std::array<QWidget*, 2>& views);

  /// Returns the commands of the workspaces.
  [[nodiscard]] QList<QAction*> workspaces() const;
  /// Leaves the home page: shows the docks.
  void leaveHome();
  /// Shows the simulated view beside the docks where the workspace has none.
  void showView();
  void save() const;
  /// Restores the saved layout before the window is shown, and fits it into the screen.
  void restore();
  /// Resets docks and tool bar; the window keeps its place.
  void reset();

 private:
  /// A set of docks for a task.
  struct Workspace {
    QAction* action;
    QList<QDockWidget*> docks;
    bool hasView;
  };

  void placeDocks();
  void addCommands(QMenu* menu);
  void addWorkspaces(QMenu* menu);
  void addDockCommands(QMenu* menu);
  void arrange(const Workspace& workspace);
  void resize(const Workspace& workspace);
  void toggle(QDockWidget* dock);
  [[nodiscard]] bool hasFocusIn(const QWidget* part) const;
  void toggle(Section* section);
  void showOnly(QAction* action, bool isView);
  [[nodiscard]] bool isHome() const;
  void showAll();
  void place(const QByteArray& geometry);
  void fitScreen();
  void fitOnceFramed();
  [[nodiscard]] QList<QDockWidget*> docks() const;
  bool eventFilter(QObject* watched, QEvent* event) override;

  QMainWindow* m_window;
  Parts m_parts;
  std::array<QWidget*, 2> m_views;
  std::vector<Workspace> m_workspaces;
  QActionGroup* m_group;
  QAction* m_onlyView = nullptr;
  QAction* m_onlyScene = nullptr;
  bool m_isFramed = false;  ///< the desktop has added a frame to the window
  /// The docks before the home page, or one view alone, hid them; empty: not in such a mode, or
  /// those of the first workspace.
  QByteArray m_before;
  bool m_hadView = true;  ///< the simulated view was shown before one view alone was
};

}  // namespace hogelscope
