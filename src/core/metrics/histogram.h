// SPDX-License-Identifier: BSD-3-Clause
// Luma histogram of an image.
#pragma once

#include <array>
#include <cstddef>

#include "core/optics/image.h"

namespace hogelscope {

/// Pixel counts by luma, 0 … 255.
using Histogram = std::array<std::size_t, 256>;

/// Counts the seen pixels by their luma (BT.709), rounded half up.
Histogram lumaHistogram(const Image& image);

}  // namespace hogelscope
