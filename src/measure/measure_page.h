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

/// How far simulated contrast is from its law.
struct Agreement {
  int gratings = 0;  ///< that have both
  double most = 0;   ///< |difference|
};
Agreement agreementOf(const std::vector<MeasuredFigure>& figures);

/// A length below a decimetre is read in mm; other values are read in their own unit.
struct ReadUnit {
  std::string name;
  double factor = 1;  ///< of values
};
ReadUnit readUnitOf(const MeasuredFigure& one);
/// Returns a value with four digits that count; "∞" and, for NaN, a dash.
std::string readValue(double value);

/// Returns measure.html.
std::string measurePage(const MeasureRequest& request, const Bench& bench,
                        const Measured& measured);

}  // namespace hogelscope
