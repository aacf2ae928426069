// SPDX-License-Identifier: BSD-3-Clause
// The PSNR of a report's rows over their states or viewing angles, one series for each test.
#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/axis.h"

namespace hogelscope {

class ReportChart {
 public:
  struct Point {
    std::size_t row = 0;     ///< of the report
    std::size_t series = 0;  ///< its test
    double across = 0;       ///< the state's number, from 1, or the angle in degrees
    double psnr = 0;         ///< dB; infinite: identical. Without a number there is no point
  };

  ReportChart() = default;
  ReportChart(std::vector<Point> points, QString titleAcross, std::vector<QString> series);

  /// A Paint (chart/painting.h) for any size from about 250×150 points. Identical views lie in a
  /// strip of their own above.
  void paint(QPainter& painter, const QSizeF& size) const;
  /// The row of the nearest point, at most a few points away from `place`.
  [[nodiscard]] std::optional<std::size_t> rowAt(const QPointF& place, const QSizeF& size) const;
  /// Where a row's point is; none where it has none.
  [[nodiscard]] std::optional<QPointF> placeOf(std::size_t row, const QSizeF& size) const;
  /// Highlights a row.
  void select(std::optional<std::size_t> row) { m_selected = row; }
  [[nodiscard]] bool isEmpty() const { return m_points.empty(); }

 private:
  struct Area;
  [[nodiscard]] Area areaOf(const QSizeF& size) const;
  void paintFrame(QPainter& painter, const Area& area) const;
  void paintPoints(QPainter& painter, const Area& area) const;
  void paintLegend(QPainter& painter, const Area& area) const;

  std::vector<Point> m_points;
  QString m_titleAcross;
  std::vector<QString> m_series;
  std::optional<std::size_t> m_selected;
};

}  // namespace hogelscope
