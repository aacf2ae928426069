// SPDX-License-Identifier: BSD-3-Clause
// Where the window and its docks are: from one start to the next, for a task, and with the
// simulated view or the scene alone. What a dock's key does.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QRect>

class QAction;
class QDockWidget;
class QMainWindow;
class QStyle;
class QTabBar;
class QWidget;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

/// A window with its frame, shrunk and moved no more than it takes to lie within the screen.
QRect fitted(QRect frame, const QRect& screen);

class WindowLayout : public QObject {
  Q_OBJECT

 public:
  /// What the window is now, with all its docks, is what reset() goes back to. `window` owns it.
  WindowLayout(QMainWindow* window, const Ui::MainWindow& ui);

  void save() const;
  /// Before the window is shown; it fits the screen then, also where a larger one was kept.
  void restore();
  /// Docks, tool bars and splitter; the window stays where it is.
  void reset();

 private:
  void connectDocks();
  void connectTasks();
  void connectParts();
  void arrange(const QList<QDockWidget*>& docks, const QList<QWidget*>& parts);
  void showOnly(QAction* action, QWidget* part);
  void showAll();
  void place(const QByteArray& geometry);
  void fitScreen();
  void fitOnceFramed();
  void narrow(QTabBar* tabs);
  bool eventFilter(QObject* watched, QEvent* event) override;

  QMainWindow* m_window;
  const Ui::MainWindow& m_ui;
  QByteArray m_docks;
  QByteArray m_split;
  QStyle* m_tabStyle;
  bool m_isFramed = false;  ///< the desktop has put a frame around the window
  QByteArray m_before;      ///< the docks before one part was shown alone; empty: none is
};

}  // namespace hogelscope
