// SPDX-License-Identifier: BSD-3-Clause
// Animations along paths of a camera: numbered images, and a video of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/scene/view_source.h"

namespace hogelscope {

struct AnimationRequest {
  ViewSource source;
  std::vector<CameraState> states;  ///< in order; their names are those of the images
  std::filesystem::path folder;     ///< created if missing
  int framesPerSecond = 10;
  std::string ffmpeg;  ///< the program; empty: no video
};

/// Throws InputError if the folder has frames already or cannot be written to, or a video's frames
/// have different sizes.
void checkAnimation(const std::vector<CameraState>& states, const std::filesystem::path& folder,
                    bool hasVideo);

/// Writes the states' images as PNG and, with ffmpeg, animation.mp4: all files or none. Throws
/// InputError as checkAnimation() and VideoWriter do, or if a view cannot be rendered. Throws
/// Cancelled.
void writeAnimation(const AnimationRequest& request, const Progress& progress);

}  // namespace hogelscope
