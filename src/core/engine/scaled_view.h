// SPDX-License-Identifier: BSD-3-Clause
// Pictures of fewer pixels, and their way back to full size, or of fewer hogels and directions:
// what a moving window shows.
#pragma once

#include "core/optics/simulate.h"

namespace hogelscope {

/// The view with one pixel for each method.scale × method.scale of them, at their middle, and with
/// method.scale 1; the last ones may reach beyond the picture.
View reduced(const View& view);

/// A first look at a view of a light field that is not in memory: that of its overview, whose
/// directions are too wide to leak into each other. Any other view stays as it is.
View overview(const View& view);

/// A reduced picture at full size: colours bilinear between its pixels, seen as the nearest one.
Image enlarged(const Image& image, int scale, const std::array<int, 2>& res);
FloatImage enlarged(const FloatImage& image, int scale, const std::array<int, 2>& res);
/// Red, green and blue of pixel (x, y) of the enlarged picture.
std::array<std::uint8_t, 3> enlargedPixel(const Image& image, int scale, int x, int y);

}  // namespace hogelscope
