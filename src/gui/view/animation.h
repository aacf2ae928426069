// SPDX-License-Identifier: BSD-3-Clause
// Animations over the states: their dialog and their files.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/simulate.h"
#include "gui/widgets/dialogs.h"

class QCheckBox;

namespace hogelscope {

/// An animation along camera states: numbered images, and a video of them made by ffmpeg.
/// ffmpeg writes into a file without a name (AtomicFile), so a killed one leaves nothing.
struct AnimationRequest {
  std::vector<RenderJob> views;  ///< in order
  std::filesystem::path folder;  ///< created if missing; file names are fixed
  int framesPerSecond = 10;
  /// The ffmpeg program; empty: no video.
  std::filesystem::path ffmpeg;
};

/// Writes frame_0001.png … and, with ffmpeg, animation.mp4 (H.264, or ffmpeg's default for MP4):
/// all files or none. Throws InputError if the folder has frames already or cannot be written to, a
/// view cannot be rendered, a video's frames have different sizes, or ffmpeg fails. Throws
/// Cancelled.
void writeAnimation(const AnimationRequest& request, const Progress& progress);

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
