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

}  // namespace hogelscope
