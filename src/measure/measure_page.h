// SPDX-License-Identifier: BSD-3-Clause
// The page and the plots of --measure.
#pragma once

#include <string>
#include <vector>

#include "measure/measure_run.h"
#include "page/figure.h"
#include "page/map_plot.h"

namespace hogelscope {

/// Returns contrast over depth and detail, and the share of the panel seen from above; without
/// cells if the figures have none.
MapPlot mtfMap(const Bench& bench, const std::vector<MeasuredFigure>& figures);
MapPlot zoneMap(const Bench& bench, const std::vector<MeasuredFigure>& figures);

/// Returns the plots of all figures that have several places.
std::vector<Figure> plotsOf(const Bench& bench, const std::vector<MeasuredFigure>& figures);

/// Returns measure.html.
std::string measurePage(const MeasureRequest& request, const Bench& bench,
                        const std::vector<MeasuredFigure>& figures);

}  // namespace hogelscope
