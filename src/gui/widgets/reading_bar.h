// SPDX-License-Identifier: BSD-3-Clause
// How far the reading of a light field, or the writing of pictures, is, with a button that stops
// it; in the status bar.
#pragma once

#include "gui/widgets/polled_bar.h"

namespace hogelscope {

class ReadingBar : public QWidget {
  Q_OBJECT

 public:
  /// `what` is read, and stands in the bar. Hidden at first; to be shown while it is read. Other
  /// work has its own tooltips.
  ReadingBar(const QString& what, PolledBar::Share share, QWidget* parent,
             const QString& barHelp = tr("How much has been read"),
             const QString& stopHelp =
                 tr("Stops reading; the window stays as it is without what was read"));

 Q_SIGNALS:
  void stopAsked();
};

}  // namespace hogelscope
