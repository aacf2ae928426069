// SPDX-License-Identifier: BSD-3-Clause
// Layout of the chart of speed against accuracy: frame, axes, the band of zero errors.
#pragma once

#include <QFont>
#include <QLineF>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "chart/painting.h"
#include "core/base/axis.h"
#include "study/tradeoff.h"

namespace hogelscope {

class TradeoffAxes {
 public:
  /// Creates axes for all measured rows in `area`, with texts in `font`.
  TradeoffAxes(const std::vector<TradeoffRow>& rows, const QRectF& area, const QFont& font);

  /// Returns the row's point; none for a row without a time or an error.
  std::optional<QPointF> positionOf(const TradeoffRow& row) const;
  /// Returns the interquartile line of a measured row's times, through its point.
  QLineF quartilesOf(const TradeoffRow& row) const;
  /// Returns the line of the interval that a measured row's error is in, as far as it is in the
  /// plot; null where the error is that of all pixels.
  QLineF errorBarOf(const TradeoffRow& row) const;
  const QFont& font() const { return m_font; }
  /// Returns the size of the text in pixels.
  double em() const { return m_em; }
  /// Returns the parts of the plot: the area above the band of zeros, and the band.
  std::vector<QRectF> areas() const;
  /// Returns the lines at 60 and 30 views per second, within the time axis.
  std::vector<QLineF> guides() const;
  /// Returns the places of the texts within the plot.
  std::vector<QRectF> captionBoxes() const;

  /// Paints everything but the methods. Lines leave out `gaps`, which hold names.
  void paint(QPainter& painter, const ChartColours& colours, const QString& title,
             const std::vector<QRectF>& gaps) const;

 private:
  bool hasTimeTitle() const { return m_area.height() >= 16 * m_em; }
  double x(double milliseconds) const;
  double y(double rmse) const;  ///< rmse > 0
  void placeGuideCaptions();
  void placeZeroCaption(const std::vector<TradeoffRow>& rows);
  void paintGround(QPainter& painter, const ChartColours& colours, const QRectF& box) const;
  void paintTimes(QPainter& painter, const ChartColours& colours) const;
  void paintErrors(QPainter& painter, const ChartColours& colours) const;
  void paintTitles(QPainter& painter, const ChartColours& colours, const QString& title) const;

  QRectF m_area;
  QFont m_font;
  double m_em;
  QRectF m_plot;  ///< the area of errors > 0
  QRectF m_zero;  ///< the band of errors 0; empty if there are none
  Axis m_times;   ///< of log10
  Axis m_errors;  ///< of log10
  std::vector<std::pair<QRectF, QString>> m_captions;
};

/// Paints one line of text, which may reach beyond `box`.
void paintText(QPainter& painter, const QRectF& box, int flags, const QString& words);
/// Formats a value with two digits, without powers of ten up to a million.
QString figureText(double value);
/// Returns a text such as "88 ms" or "2.7 s".
QString timeText(double milliseconds);

}  // namespace hogelscope
