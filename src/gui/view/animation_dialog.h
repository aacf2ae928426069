// SPDX-License-Identifier: BSD-3-Clause
// Dialog of the settings of an animation along the states.
#pragma once

#include "gui/widgets/size_dialog.h"

class QCheckBox;

namespace hogelscope {

class AnimationDialog : public SizeDialog {
  Q_OBJECT

 public:
  /// `ffmpeg` is the program's path; "": not installed.
  AnimationDialog(const QSize& proposed, const QString& ffmpeg, QWidget* parent);

  [[nodiscard]] bool hasVideo() const;
  [[nodiscard]] int framesPerSecond() const;

 private:
  QCheckBox* m_video;
  QSpinBox* m_rate;
};

}  // namespace hogelscope
