// SPDX-License-Identifier: BSD-3-Clause
// Marks that are painted over an image, in device pixels. They are black and white, or grey, which
// is visible on any image.
#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QRect>

#include "picture/image_placement.h"

namespace hogelscope {

/// Paints lines between the pixels, from 8 device pixels per pixel on.
void paintPixelGrid(QPainter& painter, const QRect& clip, const Placement& at, const QSize& image);
/// Paints a line around pixels, large enough to be visible at any zoom. An empty outline has none.
void paintPixelMarks(QPainter& painter, const QRect& clip, const Placement& at,
                     const QPainterPath& outline);
/// Paints a dashed line around a rectangle of pixels.
void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region);
/// Paints the line between two images that are wiped, with its handle. `ratio` is that of device
/// pixels to the widget's.
void paintWipe(QPainter& painter, int column, int height, double ratio);

}  // namespace hogelscope
