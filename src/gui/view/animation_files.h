// SPDX-License-Identifier: BSD-3-Clause
// An animation along camera states: numbered pictures, and a video of them by the program ffmpeg.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/simulate.h"

namespace hogelscope {

struct AnimationRequest {
  std::vector<RenderJob> views;  ///< in order
  std::filesystem::path folder;  ///< made where it is missing; the files have one name in each
  int framesPerSecond = 10;
  /// The program; empty: no video.
  std::filesystem::path ffmpeg;
};

/// Writes frame_0001.png … and, with ffmpeg, animation.mp4 (H.264, or what ffmpeg has for MP4). All
/// files are there then, or none. Throws InputError: the folder has frames already or cannot be
/// written to, a view cannot be rendered, a video's frames are of different sizes, or ffmpeg says
/// why not; and Cancelled.
void writeAnimation(const AnimationRequest& request, const Progress& progress);

}  // namespace hogelscope
