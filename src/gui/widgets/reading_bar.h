// SPDX-License-Identifier: BSD-3-Clause
// A progress bar with a stop button for the status bar, for reading a light field or writing
// images.
#pragma once

#include "gui/widgets/polled_bar.h"

namespace hogelscope {

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
