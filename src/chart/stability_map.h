// SPDX-License-Identifier: BSD-3-Clause
// The maps of stability.png: the coefficients for which each lens inverse is right.
#pragma once

#include "chart/painting.h"
#include "study/lens_maps.h"

namespace hogelscope {

/// Paints one row of maps for each plane, one column for each method, and a legend below.
void paintStabilityMaps(QPainter& painter, const QSizeF& size, const std::vector<LensMap>& maps);

/// Returns the size in points for which the maps are designed.
QSize stabilityMapsSize();

}  // namespace hogelscope
