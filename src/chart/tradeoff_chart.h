// SPDX-License-Identifier: BSD-3-Clause
// Chart of speed against accuracy with one point per method, for the window and for files.
#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "chart/painting.h"
#include "chart/recommendations.h"
#include "chart/tradeoff_axes.h"
#include "chart/tradeoff_names.h"
#include "study/tradeoff.h"

namespace hogelscope {

class TradeoffChart {
 public:
  /// `question` begins the title of the error, such as "Error against the smooth ideal". Rows
  /// without a time (> 0) or an error (>= 0) are omitted.
  TradeoffChart(std::vector<TradeoffRow> rows, std::string question);

  /// Paints the chart of a window at any size from about 300×150 pixels, with texts in the
  /// painter's font: names of the Pareto front, rings around the chosen row and row pointed at.
  void paint(QPainter& painter, const QSizeF& size, const ChartColours& colours) const;
  /// Paints the chart of a file (Paint, chart/painting.h): more names, nothing chosen.
  void paintFile(QPainter& painter, const QSizeF& size) const;

  /// Returns the row whose point in the window's chart is the nearest within a few pixels of
  /// `place`, or whose name is there.
  std::optional<std::size_t> rowAt(const QPointF& place, const QSizeF& size,
                                   const QFont& font) const;
  /// Returns the axes of a chart of `size`, above the legend.
  TradeoffAxes axes(const QSizeF& size, const QFont& font) const;

  void select(std::optional<std::size_t> row) { m_selected = row; }
  /// Sets the row pointed at.
  void point(std::optional<std::size_t> row) { m_pointed = row; }
  std::optional<std::size_t> pointed() const { return m_pointed; }
  const std::vector<TradeoffRow>& rows() const { return m_rows; }

 private:
  void paintAll(QPainter& painter, const QSizeF& size, const ChartColours& colours,
                Names which) const;
  void paintMarkers(QPainter& painter, const TradeoffAxes& axes, const ChartColours& colours) const;
  void paintLegend(QPainter& painter, const QRectF& box, const ChartColours& colours,
                   QStringList hints) const;

  std::vector<TradeoffRow> m_rows;
  std::string m_question;
  std::optional<std::size_t> m_selected;
  std::optional<std::size_t> m_pointed;
};

/// Paints the marker of a method: a shape for each way to save time, grey for several; hollow if
/// another row is better.
void paintMarker(QPainter& painter, const QPointF& centre, double radius, const TradeoffRow& row,
                 const ChartColours& colours);

/// Returns the colour of the ring around the method for a purpose.
QColor ringColour(Purpose purpose, const ChartColours& colours);

}  // namespace hogelscope
