// SPDX-License-Identifier: BSD-3-Clause
// Paints the depths around a panel, even in dioptres of the eye: the sharp ones, and the content's.
#pragma once

#include <QPainter>
#include <array>
#include <optional>

#include "core/panel/design_numbers.h"

namespace hogelscope {

struct DepthColours {
  QColor frame, ground;
  QColor sharp, content;  ///< the depths
  QColor text;            ///< the panel and the numbers
};

/// Paints the bar in the upper half, numbers in the painter's font below it. `content` are its
/// depths in metres, the back one first. Without an eye in front of the panel the bar is empty.
void paintDepthBar(QPainter& painter, const QSizeF& size, const SharpDepths& sharp,
                   const std::optional<std::array<double, 2>>& content,
                   const DepthColours& colours);

/// Formats a depth in metres as centimetres with a sign.
QString inCentimetres(double depth);

}  // namespace hogelscope
