// SPDX-License-Identifier: BSD-3-Clause
// Legend of the chart of speed against accuracy: numbered methods with their values.
#pragma once

#include <QFont>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "chart/recommendations.h"
#include "study/tradeoff.h"

namespace hogelscope {

struct LegendLine {
  std::size_t row = 0;
  std::optional<Purpose> purpose;  ///< a purpose of the row above; empty for the row itself
  QRectF box;
};

/// The layout of the legend. Columns are distances from the lines' left edge; the marker precedes
/// the number.
struct TradeoffLegend {
  QFont font;
  double numberEnd = 0;
  double name = 0;
  double timeEnd = 0;  ///< 0 if there is no space for times and errors
  std::vector<LegendLine> lines;
};

/// Lays out the legend at the top of `area`, below a title line, in the largest font of at most
/// `size` that fits, from fast to slow.
TradeoffLegend legendOf(const std::vector<TradeoffRow>& rows, const QRectF& area, const QFont& font,
                        double size);

/// Returns the method's name, with an asterisk if it was measured on part of the pixels.
QString legendName(const TradeoffRow& row);

/// Formats a value with two digits, without powers of ten up to a million.
QString figureText(double value);

}  // namespace hogelscope
