// SPDX-License-Identifier: BSD-3-Clause
// Decoding of texture images: PNG and JPEG, from memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reading.h"

namespace hogelscope::mesh {

/// 8-bit RGB, row by row from the top left.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// A PNG or JPEG, and the names for messages: of its file, and its own in that file.
struct EncodedPicture {
  std::string_view bytes;
  std::string file;
  std::string name;
};

/// Returns the number of pixels in its header. Throws unless it is a PNG or JPEG of 1 to 2^26
/// pixels.
double pixelsOf(const EncodedPicture& picture);

/// Decodes an image without alpha. Throws for damaged bytes, and if the listener cancels.
Picture decoded(const EncodedPicture& picture, const Reading& reading);

}  // namespace hogelscope::mesh
