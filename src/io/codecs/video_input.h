// SPDX-License-Identifier: BSD-3-Clause
// Input of videos by FFmpeg's libraries.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "io/images/codecs.h"

namespace hogelscope {

/// Opens a video; `format` is FFmpeg's name of its container (videoFormatOf()). The facts are known
/// after prepare(0). Throws InputError that names the file.
std::unique_ptr<ImageInput> openVideo(const std::filesystem::path& file, const std::string& format);

}  // namespace hogelscope
