// SPDX-License-Identifier: BSD-3-Clause
// Input and output of images by OpenImageIO.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "io/images/codecs.h"

namespace hogelscope {

/// Opens a file; the next function creates one. Both throw InputError that names the file.
std::unique_ptr<ImageInput> openByOpenImageIo(const std::filesystem::path& file,
                                              const std::string& format);
std::unique_ptr<ImageOutput> createByOpenImageIo(const std::filesystem::path& file,
                                                 const ImageSpec& spec, ByteOutput& bytes);

}  // namespace hogelscope
