// SPDX-License-Identifier: BSD-3-Clause
// The pictures of textures: PNG and JPEG, out of memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope::mesh {

/// 8-bit RGB from the top left, row by row.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Decodes a PNG or JPEG; alpha is left out. `name` says in a message which picture it is. Throws
/// on any other or damaged bytes, and on more than 2^26 pixels.
Picture decodePicture(std::string_view bytes, const std::string& file, const std::string& name);

}  // namespace hogelscope::mesh
