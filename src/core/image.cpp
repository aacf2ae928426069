// SPDX-License-Identifier: BSD-3-Clause
// How a value becomes a pixel.
#include "core/image.h"

#include <cmath>

namespace hogelscope {

std::uint8_t quantised(double codeValue) {
  if (!(codeValue > 0)) return 0;
  if (codeValue >= 255) return 255;
  return static_cast<std::uint8_t>(std::floor(codeValue + 0.5));
}

}  // namespace hogelscope
