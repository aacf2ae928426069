// SPDX-License-Identifier: BSD-3-Clause
// Paints a map of page/map_plot in the window and for its file.
#pragma once

#include <QPainter>

#include "chart/painting.h"
#include "page/map_plot.h"

namespace hogelscope {

/// Paints at any size from about 250×150 pixels in the painter's font.
void paintMap(QPainter& painter, const QSizeF& size, const MapPlot& plot,
              const ChartColours& colours);

}  // namespace hogelscope
