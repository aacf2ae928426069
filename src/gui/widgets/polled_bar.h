// SPDX-License-Identifier: BSD-3-Clause
// A progress bar that asks how far the work is, ten times a second while it can be seen.
#pragma once

#include <QProgressBar>
#include <QTimer>
#include <functional>

namespace hogelscope {

/// Work on another thread keeps its share in an atomic number. A signal for each step would fill
/// the window's queue, and whatever comes next would wait until each of them has been painted.
class PolledBar : public QProgressBar {
  Q_OBJECT

 public:
  /// Says how much is done, 0 … 1.
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
