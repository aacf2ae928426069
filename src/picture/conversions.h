// SPDX-License-Identifier: BSD-3-Clause
// Images of core as Qt has them, and back.
#pragma once

#include <QImage>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/image.h"

namespace hogelscope {

struct RenderJob;

/// Returns a copy of the image, 8 bits a channel.
QImage toQImage(const Image& image);
/// Returns a part of a picture. A null mask means that all of its pixels are seen.
Image toImage(const QImage& picture, const QImage& mask, const QRect& part);
/// Returns RGB row by row, or RGBA that is not premultiplied.
std::vector<std::uint8_t> bytesOf(const QImage& picture, bool hasAlpha = false);

/// Returns the mask of a view with the end of each ray (RayEnd) as index, white where the display
/// is seen.
QImage withReasons(const QImage& seen, const RenderJob& job, const Progress& progress);

}  // namespace hogelscope
