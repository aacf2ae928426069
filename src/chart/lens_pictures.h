// SPDX-License-Identifier: BSD-3-Clause
// The maps of lenses.png: where each inverse of a lens is right within the lens' own image.
#pragma once

#include "chart/painting.h"
#include "study/stability.h"

namespace hogelscope {

/// The largest number of lenses in one image; later ones are only in the table.
constexpr std::size_t mostLensPictures = 24;

/// Paints the outcome of every measured pixel: one row for each lens starting at `first`, one
/// column for each method, and a legend below.
void paintLensPictures(QPainter& painter, const QSizeF& size, const Stability& stability,
                       std::size_t first);

/// Returns the size in points for which the maps are designed.
QSize lensPicturesSize(const Stability& stability, std::size_t first);

}  // namespace hogelscope
