// SPDX-License-Identifier: BSD-3-Clause
// Chart of speed against accuracy with one point per method, for the window and for files.
#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "chart/tradeoff_axes.h"
#include "study/tradeoff.h"

namespace hogelscope {

struct TradeoffLegend;

class TradeoffChart {
 public:
  /// `question` is the title of the error, such as "Error against the display as built". Rows
  /// without a time (> 0) or an error (>= 0) are omitted.
  TradeoffChart(std::vector<TradeoffRow> rows, std::string question);

  /// Paints the chart (Paint, chart/painting.h) at any size from about 500×400 points. Text has the
  /// painter's font, scaled with the chart.
  void paint(QPainter& painter, const QSizeF& size) const;

  /// Returns the row whose point is within a few points of `place` on a chart of `size`.
  std::optional<std::size_t> rowAt(const QPointF& place, const QSizeF& size) const;
  /// Returns each row's line in the legend; empty for a row that is not measured.
  std::vector<QRectF> nameBoxes(const QSizeF& size, const QFont& font) const;
  /// Returns the axes of a chart of `size`, left of the legend.
  TradeoffAxes axes(const QSizeF& size) const;

  /// Highlights a row.
  void select(std::optional<std::size_t> row) { m_selected = row; }
  const std::vector<TradeoffRow>& rows() const { return m_rows; }

 private:
  TradeoffLegend legend(const QSizeF& size, const QFont& font) const;
  void paintKey(QPainter& painter, const TradeoffAxes& axes) const;
  void paintFront(QPainter& painter, const TradeoffAxes& axes) const;
  void paintSpreads(QPainter& painter, const TradeoffAxes& axes) const;
  void paintMarkers(QPainter& painter, const TradeoffAxes& axes) const;
  void paintMarker(QPainter& painter, const QPointF& point, double em, std::size_t row) const;
  void paintNumbers(QPainter& painter, const TradeoffAxes& axes) const;
  void paintLegend(QPainter& painter, const TradeoffLegend& legend) const;
  void paintLegendRow(QPainter& painter, const TradeoffLegend& legend, const QRectF& box,
                      std::size_t row, std::size_t number) const;

  std::vector<TradeoffRow> m_rows;
  std::string m_question;
  std::optional<std::size_t> m_selected;
};

}  // namespace hogelscope
