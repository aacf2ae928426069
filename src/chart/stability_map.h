// SPDX-License-Identifier: BSD-3-Clause
// The maps of stability.png: which way to invert a lens holds for which coefficients.
#pragma once

#include "chart/painting.h"
#include "study/lens_maps.h"

namespace hogelscope {

/// One row of maps for each plane, one column for each method, and a legend below.
void paintStabilityMaps(QPainter& painter, const QSizeF& size, const std::vector<LensMap>& maps);

/// The size, in points, that the maps are drawn for.
QSize stabilityMapsSize();

}  // namespace hogelscope
