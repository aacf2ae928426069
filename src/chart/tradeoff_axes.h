// SPDX-License-Identifier: BSD-3-Clause
// Where things lie on the chart of speed against accuracy: frame, axes, the band of the errors 0.
#pragma once

#include <QFont>
#include <QLineF>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "core/base/axis.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

class TradeoffAxes {
 public:
  /// For a plot of `size` in points, legend excluded, whose axes hold all measured rows.
  TradeoffAxes(const std::vector<TradeoffRow>& rows, const QSizeF& size);

  /// The row's point; none for a row without a time or an error.
  std::optional<QPointF> positionOf(const TradeoffRow& row) const;
  /// The spread of the times of a measured row, through its point.
  QLineF quartilesOf(const TradeoffRow& row) const;
  /// The size of the text, points.
  double em() const { return m_em; }
  /// The parts of the plot: above the band of zeros, and the band.
  std::vector<QRectF> areas() const;
  /// The lines at 60 and 30 views per second, as far as the time axis reaches.
  std::vector<QLineF> guides() const;
  /// The words in the band; empty where there is no band.
  QRectF zeroCaption(const QFont& font) const;

  void paint(QPainter& painter, const QString& title) const;

 private:
  double x(double milliseconds) const;
  double y(double rmse) const;  ///< > 0
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
  QRectF m_plot;  ///< of errors > 0
  QRectF m_zero;  ///< of errors 0; empty where there are none
  Axis m_times;   ///< of log10
  Axis m_errors;  ///< of log10
};

/// `font` at a size in points of the chart.
QFont sized(QFont font, double size, bool isBold = false);

}  // namespace hogelscope
