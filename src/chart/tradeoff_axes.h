// SPDX-License-Identifier: BSD-3-Clause
// Layout of the chart of speed against accuracy: frame, axes, the band of zero errors.
#pragma once

#include <QFont>
#include <QLineF>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "core/base/axis.h"
#include "study/tradeoff.h"

namespace hogelscope {

class TradeoffAxes {
 public:
  /// Creates axes for all measured rows, for a plot of `size` in points without the legend.
  TradeoffAxes(const std::vector<TradeoffRow>& rows, const QSizeF& size);

  /// Returns the row's point; none for a row without a time or an error.
  std::optional<QPointF> positionOf(const TradeoffRow& row) const;
  /// Returns the interquartile line of a measured row's times, through its point.
  QLineF quartilesOf(const TradeoffRow& row) const;
  /// Returns the text size in points.
  double em() const { return m_em; }
  /// Returns the parts of the plot: the area above the band of zeros, and the band.
  std::vector<QRectF> areas() const;
  /// Returns the lines at 60 and 30 views per second, within the time axis.
  std::vector<QLineF> guides() const;
  /// Returns the place of the caption in the band; empty without a band.
  QRectF zeroCaption(const QFont& font) const;

  void paint(QPainter& painter, const QString& title) const;

 private:
  double x(double milliseconds) const;
  double y(double rmse) const;  ///< rmse > 0
  void paintGround(QPainter& painter, const QRectF& box) const;
  void paintFrames(QPainter& painter) const;
  void paintGuides(QPainter& painter) const;
  void paintTimes(QPainter& painter) const;
  void paintErrors(QPainter& painter) const;
  void paintPsnr(QPainter& painter) const;
  void paintZero(QPainter& painter) const;
  void paintTitles(QPainter& painter, const QString& title) const;

  QSizeF m_size;
  double m_em;
  QRectF m_plot;  ///< the area of errors > 0
  QRectF m_zero;  ///< the band of errors 0; empty if there are none
  Axis m_times;   ///< of log10
  Axis m_errors;  ///< of log10
};

/// Returns `font` at a size in points of the chart.
QFont sized(QFont font, double size, bool isBold = false);

}  // namespace hogelscope
