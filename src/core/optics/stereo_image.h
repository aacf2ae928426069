// SPDX-License-Identifier: BSD-3-Clause
// One image of both eyes' images, for people to look at with or without glasses.
#pragma once

#include <span>
#include <string_view>

#include "core/optics/image.h"

namespace hogelscope {

enum class StereoMode {
  sideBySide,    ///< the left eye's image on the left: for parallel eyes and stereo viewers
  anaglyph,      ///< for glasses with red on the left and cyan on the right
  anaglyphGrey,  ///< the same of the images' luminance
  crossEyed      ///< the right eye's image on the left
};

/// Returns the names used on the command line, in the order of StereoMode.
std::span<const std::string_view> stereoModeNames();

/// Joins images of equal size. Anaglyphs are by E. Dubois' least-squares projection (A projection
/// method to generate anaglyph stereo images, IEEE ICASSP 2001), in linear light, limited to the
/// range of code values; a pixel of them is seen if one eye sees it.
Image stereoImage(const Image& left, const Image& right, StereoMode mode);
FloatImage stereoImage(const FloatImage& left, const FloatImage& right, StereoMode mode);

}  // namespace hogelscope
