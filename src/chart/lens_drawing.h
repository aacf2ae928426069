// SPDX-License-Identifier: BSD-3-Clause
// Paints a lens by the straight lines of the world in the image, the fold and the area without
// rays.
#pragma once

#include <QPainter>

#include "chart/painting.h"
#include "core/lens/lens_grid.h"

namespace hogelscope {

/// Paints the grid of an image that has pixels.
void paintLens(QPainter& painter, const QSizeF& size, const LensGrid& grid,
               const ChartColours& colours);

}  // namespace hogelscope
