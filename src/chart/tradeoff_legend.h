// SPDX-License-Identifier: BSD-3-Clause
// The legend of the chart of speed against accuracy: the methods by number, with their figures.
#pragma once

#include <QFont>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "chart/recommendations.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

struct LegendLine {
  std::size_t row = 0;
  std::optional<Purpose> purpose;  ///< of the row above; the row itself if empty
  QRectF box;
};

/// Columns are distances from the left edge of the lines: a marker comes before the number.
struct TradeoffLegend {
  QFont font;
  double numberEnd = 0;
  double name = 0;
  double timeEnd = 0;  ///< 0 where there is no room for times and errors
  std::vector<LegendLine> lines;
};

/// Lays out the legend from the top of `area`, under a line for its titles, in the largest font of
/// at most `size` that fits, and from fast to slow.
TradeoffLegend legendOf(const std::vector<TradeoffRow>& rows, const QRectF& area, const QFont& font,
                        double size);

/// The method's name, with an asterisk if it is measured on part of the pixels.
QString legendName(const TradeoffRow& row);

/// With two digits, but without powers of ten up to a million.
QString figureText(double value);

}  // namespace hogelscope
