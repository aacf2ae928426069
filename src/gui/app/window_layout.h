// SPDX-License-Identifier: BSD-3-Clause
// The layout of the window and its docks: saved between runs, predefined for tasks, or with one
// view alone. Also defines the effect of a dock's key.
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

/// Returns the window's frame, shrunk and moved only as far as needed to fit the screen.
QRect fitted(QRect frame, const QRect& screen);

class WindowLayout : public QObject {
  Q_OBJECT

 public:
  /// Takes the window's current state, with all docks, as the default for reset(). `window` owns
  /// it.
  WindowLayout(QMainWindow* window, const Ui::MainWindow& ui);

  void save() const;
  /// Restores the saved layout before the window is shown, and fits it into the screen.
  void restore();
  /// Resets docks, tool bars and splitter; the window keeps its place.
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
  bool m_isFramed = false;  ///< the desktop has added a frame to the window
  QByteArray m_before;      ///< the docks before one view was shown alone; empty: not in that mode
};

}  // namespace hogelscope
