// SPDX-License-Identifier: BSD-3-Clause
// Joins the pictures of two eyes as Qt has them.
#pragma once

#include <QImage>

#include "core/optics/stereo_image.h"

namespace hogelscope {

/// Joins two pictures, or two masks, of one size and format as stereoImage() does. An anaglyph's
/// mask is seen where one of them is.
QImage joined(const QImage& left, const QImage& right, StereoMode mode);

}  // namespace hogelscope
