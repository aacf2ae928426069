// SPDX-License-Identifier: BSD-3-Clause
// What is painted on an image: picked pixels, a marked rectangle, a scale of colours.
#pragma once

#include <QPainter>

#include "core/metrics/error_map.h"
#include "gui/view/image_placement.h"

namespace hogelscope {

/// A frame around a pixel, large enough to be found however small the pixel is drawn.
void paintPixelMark(QPainter& painter, const QRect& clip, const Placement& at, const QPoint& pixel);

void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region);

/// At the right of `area`, with numbers and their unit.
void paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit);

}  // namespace hogelscope
