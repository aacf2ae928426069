// SPDX-License-Identifier: BSD-3-Clause
// How many pixels of an image are how bright.
#pragma once

#include <array>
#include <cstddef>

#include "core/optics/image.h"

namespace hogelscope {

/// By luma, 0 … 255.
using Histogram = std::array<std::size_t, 256>;

/// Counts the pixels that are seen by their luma (BT.709), rounded half up.
Histogram lumaHistogram(const Image& image);

}  // namespace hogelscope
