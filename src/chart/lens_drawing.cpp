// SPDX-License-Identifier: BSD-3-Clause
#include "chart/lens_drawing.h"

#include <QPainterPath>
#include <algorithm>

namespace hogelscope {

namespace {

const QColor fold(200, 40, 40);

QPolygonF polygonOf(const std::vector<Vec2>& points) {
  QPolygonF polygon;
  for (const Vec2& point : points) polygon << QPointF(point.x, point.y);
  return polygon;
}

/// Returns the transform of the image into `size`, with a margin for the grid beyond it.
QTransform fromImage(const QRectF& image, const QSizeF& size) {
  constexpr double margin = 1.12;
  const double scale =
      std::min(size.width() / (margin * image.width()), size.height() / (margin * image.height()));
  QTransform transform;
  transform.translate(size.width() / 2, size.height() / 2);
  transform.scale(scale, scale);
  transform.translate(-image.center().x(), -image.center().y());
  return transform;
}

void paintFold(QPainter& painter, const QRectF& frame, const QPolygonF& outline) {
  QPainterPath image, inside;
  image.addRect(frame);
  inside.addPolygon(outline);
  inside.closeSubpath();
  painter.fillPath(image.subtracted(inside), QBrush(fold, Qt::BDiagPattern));
  // Intersects paths, because Qt's SVG ignores clipping.
  const QPainterPath rim = QPainterPathStroker(QPen(fold, 2)).createStroke(inside);
  painter.fillPath(rim.intersected(image), fold);
}

}  // namespace

void paintLens(QPainter& painter, const QSizeF& size, const LensGrid& grid,
               const ChartColours& colours) {
  const QRectF image(-0.5, -0.5, grid.res[0], grid.res[1]);
  const QTransform transform = fromImage(image, size);
  const QRectF frame = transform.mapRect(image);
  painter.fillRect(frame, colours.background);
  painter.setPen(QPen(colours.series[0], 1));
  for (const std::vector<Vec2>& points : grid.lines)
    painter.drawPolyline(transform.map(polygonOf(points)));
  if (!grid.fold.empty()) paintFold(painter, frame, transform.map(polygonOf(grid.fold)));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.text, 1.5));
  painter.drawRect(frame);
}

}  // namespace hogelscope
