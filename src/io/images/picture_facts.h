// SPDX-License-Identifier: BSD-3-Clause
// What image files say beyond the values of one upright picture at its place: orientation, windows,
// layers, parts, pages, further pictures. It is done here, or told in a line.
#pragma once

#include <filesystem>
#include <memory>

#include "io/images/codecs.h"

namespace hogelscope {

/// Returns the input, or one that does what its file says: pictures are turned upright, are as
/// large as their display window, with black around what is stored, and have the colours of a layer
/// that is chosen; pages of a TIFF that are alike are frames. What is left out and guessed is in
/// ImageFacts::notes. Reading throws InputError if it is unclear which layer is the picture. Throws
/// InputError if the display window is larger than the file can mean.
std::unique_ptr<ImageInput> asFileSays(const std::filesystem::path& file,
                                       std::unique_ptr<ImageInput> input);

/// Whether a file named .tif or .tiff has several pages that are alike (TiffPages).
bool hasViewPages(const std::filesystem::path& file);

}  // namespace hogelscope
