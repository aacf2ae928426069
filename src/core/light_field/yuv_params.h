// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a file of raw YUV.
#pragma once

#include <array>

namespace hogelscope {

enum class YuvSampling { s420, s444 };
enum class YuvMatrix { bt709, bt601 };
enum class YuvRange { limited, full };

/// The format of one image: its planes Y, Cb, Cr, one after the other (docs/formulas.md, Raw YUV).
struct YuvParams {
  std::array<int, 2> size{0, 0};  ///< width and height in pixels, 0 = not given
  YuvSampling sampling = YuvSampling::s420;
  int bits = 8;  ///< 8: bytes; 10: words of 16 bits, the low byte first
  YuvMatrix matrix = YuvMatrix::bt709;
  YuvRange range = YuvRange::limited;
  bool operator==(const YuvParams&) const = default;
};

}  // namespace hogelscope
