// SPDX-License-Identifier: BSD-3-Clause
// What is painted on an image: picked pixels, a marked rectangle, a scale of colours.
#pragma once

#include <QPainter>
#include <QPainterPath>

#include "core/metrics/error_map.h"
#include "gui/view/image_placement.h"

namespace hogelscope {

/// A line around pixels, large enough to be found however small they are drawn.
void paintPixelMarks(QPainter& painter, const QRect& clip, const Placement& at,
                     const QPainterPath& outline);

void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region);

/// At the right of `area`, with numbers and their unit.
void paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit);

}  // namespace hogelscope
