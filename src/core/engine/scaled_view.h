// SPDX-License-Identifier: BSD-3-Clause
// Views of fewer pixels, enlarged again to full size, or of fewer hogels and directions, which the
// window shows while a camera moves; and views with any number of pixels.
#pragma once

#include "core/optics/simulate.h"

namespace hogelscope {

/// Returns the view with one pixel in the middle of each method.scale × method.scale of them, and
/// with method.scale 1; the last squares may reach beyond the image.
RenderJob reduced(const RenderJob& job);

/// Returns the state with another number of pixels over the same field: the borders of its image
/// stay where they are.
CameraState resized(const CameraState& state, const std::array<int, 2>& res);

/// Returns a quick view of a light field that is not in memory: that of its overview, whose
/// directions are too wide to leak into each other. Any other view is returned unchanged.
RenderJob overview(const RenderJob& job);

/// Enlarges a reduced image: colours are bilinear, the mask is that of the nearest pixel.
Image enlarged(const Image& image, int scale, const std::array<int, 2>& res);
FloatImage enlarged(const FloatImage& image, int scale, const std::array<int, 2>& res);
/// Returns red, green and blue of pixel (x, y) of the enlarged image.
std::array<std::uint8_t, 3> enlargedPixel(const Image& image, int scale, int x, int y);

}  // namespace hogelscope
