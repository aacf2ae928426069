// SPDX-License-Identifier: BSD-3-Clause
// The numbers of the methods, and their places beside the points of the chart.
#pragma once

#include <QFont>
#include <QLineF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "chart/tradeoff_axes.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

/// The measured rows from fast to slow, of equal time the less accurate first: the row of number
/// n is at n - 1.
std::vector<std::size_t> numbered(const std::vector<TradeoffRow>& rows);

/// The radius of a row's marker in ems; the default's has a ring.
double markerRadius(const std::vector<TradeoffRow>& rows, std::size_t row);

/// The number beside a point, or the numbers of points that lie together.
struct PointNumbers {
  std::vector<std::size_t> numbers;  ///< rising, from 1
  QRectF markers;
  QRectF box;
  std::optional<QLineF> leader;  ///< from the markers to a box that is not right beside them
};

/// "7" or "3, 8–11".
QString textOf(const PointNumbers& numbers);

/// The numbers of all measured rows, each in the first of some places around its point where it
/// covers nothing. Those that have no such place, in a chart far too small, are left out.
std::vector<PointNumbers> numbersBesidePoints(const std::vector<TradeoffRow>& rows,
                                              const TradeoffAxes& axes, const QFont& font);

/// The Pareto front as steps: from each point to the right, then down to the next.
std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes);

}  // namespace hogelscope
