// SPDX-License-Identifier: BSD-3-Clause
// Paints a lens by the straight lines of the world in the image, the fold and the area without
// rays.
#pragma once

#include <QPainter>

#include "core/lens/lens_grid.h"

namespace hogelscope {

/// Paints the grid of an image that has pixels; the image's frame has the painter's colour.
void paintLens(QPainter& painter, const QSizeF& size, const LensGrid& grid);

}  // namespace hogelscope
