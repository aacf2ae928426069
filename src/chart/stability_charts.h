// SPDX-License-Identifier: BSD-3-Clause
// The charts of --stability. stability.png: the coefficients for which each lens inverse is right;
// lenses.png: where each is right within a lens' own image.
#pragma once

#include "chart/painting.h"
#include "study/stability.h"

namespace hogelscope {

/// Paints one row of maps for each plane, one column for each method, and a legend below.
void paintStabilityMaps(QPainter& painter, const QSizeF& size, const std::vector<LensMap>& maps);

/// Returns the size in points for which the maps are designed.
QSize stabilityMapsSize();

/// The largest number of lenses in one image; later ones are only in the table.
constexpr std::size_t mostLensPictures = 24;

/// Paints the outcome of every measured pixel: one row for each lens starting at `first`, one
/// column for each method, and a legend below.
void paintLensPictures(QPainter& painter, const QSizeF& size, const Stability& stability,
                       std::size_t first);

/// Returns the size in points for which these pictures are designed.
QSize lensPicturesSize(const Stability& stability, std::size_t first);

}  // namespace hogelscope
