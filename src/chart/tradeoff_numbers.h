// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the methods beside the points of the chart.
#pragma once

#include <QFont>
#include <QLineF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "chart/tradeoff_axes.h"
#include "study/tradeoff.h"

namespace hogelscope {

/// Returns the measured rows from fast to slow, for equal times the less accurate first. The row of
/// number n is at n - 1.
std::vector<std::size_t> numbered(const std::vector<TradeoffRow>& rows);

/// Returns the radius of a row's marker in ems. The default's marker has a ring.
double markerRadius(const std::vector<TradeoffRow>& rows, std::size_t row);

/// The numbers of a point or of overlapping points.
struct PointNumbers {
  std::vector<std::size_t> numbers;  ///< ascending, from 1
  QRectF markers;
  QRectF box;
  std::optional<QLineF> leader;  ///< from the markers to a box that is not adjacent
};

/// Returns a text such as "7" or "3, 8–11".
QString textOf(const PointNumbers& numbers);

/// Returns the numbers of all measured rows, each at the first free place around its point. Numbers
/// without a free place, in a very small chart, are omitted.
std::vector<PointNumbers> numbersBesidePoints(const std::vector<TradeoffRow>& rows,
                                              const TradeoffAxes& axes, const QFont& font);

/// Returns the Pareto front as steps: from each point to the right, then down to the next.
std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes);

}  // namespace hogelscope
