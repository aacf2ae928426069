// SPDX-License-Identifier: BSD-3-Clause
// Where the window and its docks are, from one start to the next; kept in the settings. What a
// dock's key does.
#pragma once

#include <QByteArray>
#include <QObject>

class QMainWindow;
class QSplitter;

namespace hogelscope {

class WindowLayout : public QObject {
  Q_OBJECT

 public:
  /// What the window is now, with all its docks, is what reset() goes back to. `window` owns it.
  WindowLayout(QMainWindow* window, QSplitter* splitter);

  void save() const;
  void restore();
  /// Docks, tool bars and splitter; the window stays where it is.
  void reset();

 private:
  QMainWindow* m_window;
  QSplitter* m_splitter;
  QByteArray m_docks;
  QByteArray m_split;
};

}  // namespace hogelscope
