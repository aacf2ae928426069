// SPDX-License-Identifier: BSD-3-Clause
// The properties in an image file's header, and rows of its pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "core/light_field/light_field.h"

namespace hogelscope {

/// A pointer to the first value of pixels owned by the caller.
using StoredRows = std::variant<const std::uint8_t*, const std::uint16_t*, const float*>;

struct ImageFacts {
  std::size_t width = 0;
  std::size_t height = 0;
  int channels = 0;
  StoredType type = StoredType::uint8;
  /// The bits of a value in the file, 8 … 16: 10 for a PPM whose largest value is 1023; 16 for
  /// floats, 8 for fewer.
  int bits = 8;
  std::string format;      ///< such as "png"
  std::size_t frames = 1;  ///< images of the same size in the file: a video's frames
};

}  // namespace hogelscope
