// SPDX-License-Identifier: BSD-3-Clause
// Asks how an animation along the states is to be.
#pragma once

#include "gui/widgets/size_dialog.h"

class QCheckBox;

namespace hogelscope {

class AnimationDialog : public SizeDialog {
  Q_OBJECT

 public:
  /// `ffmpeg` is the program's path; "": it is not installed.
  AnimationDialog(const QSize& proposed, const QString& ffmpeg, QWidget* parent);

  [[nodiscard]] bool hasVideo() const;
  [[nodiscard]] int framesPerSecond() const;

 private:
  QCheckBox* m_video;
  QSpinBox* m_rate;
};

}  // namespace hogelscope
