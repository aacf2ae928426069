// SPDX-License-Identifier: BSD-3-Clause
// What is written beside the points of the chart of speed against accuracy, and where.
#pragma once

#include <QFont>
#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <optional>
#include <vector>

#include "chart/tradeoff_axes.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

enum class Purpose { movingView, paper, standard };

/// The purposes that a row is the answer to.
std::vector<Purpose> purposesOf(const std::vector<TradeoffRow>& rows, std::size_t row);
const char* words(Purpose purpose);

/// Points; the default's with its ring.
double markerRadius(const std::vector<Purpose>& purposes);

/// One box: the names of rows whose points lie together, or a callout of a single row.
struct TradeoffLabel {
  std::vector<std::size_t> rows;
  std::vector<Purpose> purposes;  ///< of a callout; empty otherwise
  QPointF point;
  QRectF box;
  std::optional<QLineF> leader;

  /// Line `k` of the text, from above.
  QRectF line(std::size_t k) const;
  std::size_t lines() const;
};

/// "0.52 ms, error 0.13": the last line of a callout.
QString figures(const TradeoffRow& row);

struct TradeoffLabels {
  QFont font;  ///< the largest that leaves room for all
  std::vector<TradeoffLabel> labels;
};

/// What has no place at all, on a chart far too small, is left out.
TradeoffLabels labelsOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                        const QFont& font);

/// The Pareto front as steps: from each point to the right, then down to the next.
std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes);

}  // namespace hogelscope
