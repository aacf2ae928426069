// SPDX-License-Identifier: BSD-3-Clause
// How far the reading of a light field is, with a button that stops it; in the status bar.
#pragma once

#include <QWidget>

class QProgressBar;

namespace hogelscope {

class ReadingBar : public QWidget {
  Q_OBJECT

 public:
  /// `what` is read, and stands in the bar. Hidden at first.
  ReadingBar(const QString& what, QWidget* parent);

  /// Shows it; 0 … 1.
  void advance(double done);

 Q_SIGNALS:
  void stopAsked();

 private:
  QProgressBar* m_bar;
};

}  // namespace hogelscope
