// SPDX-License-Identifier: BSD-3-Clause
// Opens pictures and videos by codecs(): what damaged files crash, in a process of its own.
#pragma once

#include <filesystem>
#include <memory>

#include "io/images/codecs.h"

namespace hogelscope {

/// Opens a picture or a video of any format but PNG, PGX and raw YUV. The content, not the ending,
/// tells the format. JPEG, TIFF, EXR, PNM, PFM and BMP are read by this process; all others by a
/// copy of it (Isolated), since their libraries crash, hang or take gigabytes for some damaged
/// files. Throws InputError that names the file.
std::unique_ptr<ImageInput> openPicture(const std::filesystem::path& file);

}  // namespace hogelscope
