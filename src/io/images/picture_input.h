// SPDX-License-Identifier: BSD-3-Clause
// Opens images and videos with codecs(), in a separate process if damaged files can crash them.
#pragma once

#include <filesystem>
#include <memory>

#include "io/images/codecs.h"

namespace hogelscope {

/// Opens an image or a video of any format except PNG, PGX and raw YUV. The content, not the
/// extension, gives the format. JPEG, TIFF, EXR, PNM, PFM and BMP are read by this process; all
/// others by a copy of it (Isolated), because their libraries crash, hang or take gigabytes for
/// some damaged files. Throws InputError that names the file.
std::unique_ptr<ImageInput> openPicture(const std::filesystem::path& file);

}  // namespace hogelscope
