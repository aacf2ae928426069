// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/histogram.h"

namespace hogelscope {

Histogram lumaHistogram(const Image& image) {
  Histogram counts{};
  for (std::size_t k = 0; k < image.pixelCount(); ++k) {
    if (image.seen[k] == 0) continue;
    const std::uint8_t* rgb = &image.rgb[3 * k];
    ++counts[quantised(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2])];
  }
  return counts;
}

}  // namespace hogelscope
