// SPDX-License-Identifier: BSD-3-Clause
// The pictures of textures: PNG and JPEG, out of memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reading.h"

namespace hogelscope::mesh {

/// 8-bit RGB from the top left, row by row.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// A PNG or JPEG, and the names for messages: of the file that it is in, and its own there.
struct EncodedPicture {
  std::string_view bytes;
  std::string file;
  std::string name;
};

/// Returns the number of pixels that its header says. Throws on anything but a PNG or JPEG of 1 to
/// 2^26 pixels.
double pixelsOf(const EncodedPicture& picture);

/// Decodes it; alpha is left out. Throws on damaged bytes, and where the listener stops.
Picture decoded(const EncodedPicture& picture, const Reading& reading);

}  // namespace hogelscope::mesh
