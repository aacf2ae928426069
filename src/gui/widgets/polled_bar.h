// SPDX-License-Identifier: BSD-3-Clause
// A progress bar that polls the progress ten times a second while visible.
#pragma once

#include <QProgressBar>
#include <QTimer>
#include <functional>

namespace hogelscope {

/// Polls work on another thread, which keeps its progress in an atomic number. Signals of each step
/// would fill the window's queue and delay all other events.
class PolledBar : public QProgressBar {
  Q_OBJECT

 public:
  /// Returns the progress, 0 … 1.
  using Share = std::function<double()>;

  explicit PolledBar(Share share, QWidget* parent = nullptr);

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

}  // namespace hogelscope
