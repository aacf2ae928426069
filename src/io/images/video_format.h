// SPDX-License-Identifier: BSD-3-Clause
// Recognises videos by their first bytes.
#pragma once

#include <filesystem>
#include <string>

namespace hogelscope {

/// Returns FFmpeg's name of a video's container, such as "mov" or "matroska"; "" for all other
/// files. Only these containers are given to FFmpeg: the texts that name other files or addresses,
/// which it would open (lists of files, HLS, DASH, SDP), are none. Pictures that begin like MP4
/// (HEIF, AVIF, Canon's raw files) are none either.
std::string videoFormatOf(const std::filesystem::path& file);

}  // namespace hogelscope
