// SPDX-License-Identifier: BSD-3-Clause
// Names of methods beside the points of the chart, and the lines between the points.
#pragma once

#include <QLineF>
#include <QRectF>
#include <QString>
#include <vector>

#include "chart/tradeoff_axes.h"
#include "study/tradeoff.h"

namespace hogelscope {

/// Returns the measured rows from fast to slow, for equal times the less accurate first.
std::vector<std::size_t> fastToSlow(const std::vector<TradeoffRow>& rows);

/// Returns the radius of a row's marker in pixels, for texts of `em` pixels. Recommended ones have
/// a ring for each purpose.
double markerRadius(const std::vector<TradeoffRow>& rows, std::size_t row, double em);

/// Returns a method's name, with an asterisk if not it but others were measured on all pixels.
QString nameOf(const std::vector<TradeoffRow>& rows, std::size_t row);

struct PlacedName {
  std::size_t row = 0;
  QString text;
  QRectF box;
};

enum class Names {
  ofFront,  ///< those of the Pareto front and of the default
  all       ///< of recommended methods with their purposes, of others once where markers overlap
};

/// Places names at the first free place around their points, those of the Pareto front below left
/// of it. A name covers no marker, no other name or caption, and no part of the front; it may lie
/// in a gap of a guide. Names without a free place are left out.
std::vector<PlacedName> placeNames(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                                   Names which);

/// Returns the Pareto front as steps: from each point to the right, then down to the next.
std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes);

}  // namespace hogelscope
