// SPDX-License-Identifier: BSD-3-Clause
// Marks painted on an image: picked pixels, a selected rectangle, a colour scale.
#pragma once

#include <QPainter>
#include <QPainterPath>

#include "core/metrics/error_map.h"
#include "gui/view/image_placement.h"

namespace hogelscope {

/// Paints a line around pixels, large enough to be visible at any zoom.
void paintPixelMarks(QPainter& painter, const QRect& clip, const Placement& at,
                     const QPainterPath& outline);

void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region);

/// Paints a colour scale at the right of `area`, with numbers and their unit.
void paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit);

}  // namespace hogelscope
