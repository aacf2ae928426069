// SPDX-License-Identifier: BSD-3-Clause
// What image files say beyond the values of one upright picture at its place: orientation, windows,
// layers, parts, pages, further pictures. It is done here, or told in a line.
#pragma once

#include <filesystem>
#include <memory>

#include "io/images/codecs.h"
#include "io/images/tiff_directories.h"

namespace hogelscope {

struct PictureFacts {
  int orientation = 1;             ///< EXIF's: 1 upright, 3 turned by 180°, 6 and 8 by 90°, …
  std::vector<PicturePart> parts;  ///< with data and display windows, layers of channels
  TiffPages pages{};
  std::size_t pictures = 1;  ///< as ImageNumbers::pictures; of which the first is read
  std::string kind{};        ///< of the file with these pictures, such as "animation"; may be ""
};

/// Collects what a file says from its reader and from its bytes. Throws InputError.
PictureFacts pictureFactsOf(const std::filesystem::path& file, const ImageFacts& facts);

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
