// SPDX-License-Identifier: BSD-3-Clause
// Widgets that start, show and stop work on another thread.
#pragma once

#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <functional>

#include "gui/widgets/task.h"

class QStatusBar;

namespace hogelscope {

/// A button that starts a task and, while that runs, stops it.
class TaskButton : public QPushButton {
  Q_OBJECT

 public:
  using QPushButton::QPushButton;

  /// Calls `start` at a click while the task does not run.
  void control(Task* task, const std::function<void()>& start);
  /// Sets the text while the task does not run, and whether it can start.
  void setIdle(const QString& text, bool canStart);
  /// Stops the task, and says so until it has ended.
  void stop();

 private:
  void follow();

  Task* m_task = nullptr;
  QString m_idleText;
  bool m_canStart = true;
};

/// Polls work on another thread ten times a second while visible. The work keeps its progress in an
/// atomic number: signals of each step would fill the window's queue and delay all other events.
class PolledBar : public QProgressBar {
  Q_OBJECT

 public:
  /// Returns the progress, 0 … 1.
  using Share = std::function<double()>;

  explicit PolledBar(Share share, QWidget* parent = nullptr);
  /// Is visible while the task runs.
  explicit PolledBar(Task* task, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void ask();

  Share m_share;
  QTimer m_timer;
};

/// A progress bar with a stop button for the status bar, for reading a light field or writing
/// images.
class ReadingBar : public QWidget {
  Q_OBJECT

 public:
  /// Creates a hidden bar labelled `what`, to be shown while the work runs. Work other than reading
  /// passes its own tooltips.
  ReadingBar(const QString& what, PolledBar::Share share, QWidget* parent,
             const QString& barHelp = tr("How much has been read"),
             const QString& stopHelp =
                 tr("Stops reading; the window stays as it is without what was read"));

 Q_SIGNALS:
  void stopAsked();
};

/// Writes files in the background, with a progress bar and a stop button in the status bar.
class FileOutput : public QObject {
  Q_OBJECT

 public:
  /// `bar` is the object name of the bar, `what` its label, `help` its tooltip.
  FileOutput(const char* bar, const QString& what, const QString& help, QStatusBar* statusBar,
             QObject* parent);

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);

 protected:
  Task* m_task;
};

}  // namespace hogelscope
