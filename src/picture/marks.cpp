// SPDX-License-Identifier: BSD-3-Clause
#include "picture/marks.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

/// Paints white on black, which is visible on any image.
void paintOutline(QPainter& painter, const QRect& clip, const QPainterPath& outline,
                  Qt::PenStyle style) {
  painter.save();
  painter.setClipRect(clip);
  painter.strokePath(outline, QPen(Qt::black, 3));
  painter.strokePath(outline, QPen(Qt::white, 1, style));
  painter.restore();
}

QPainterPath around(const QRectF& box) {
  QPainterPath path;
  path.addRect(box);
  return path;
}

QRectF inDevice(const Placement& at, const QRectF& pixels) {
  return {at.toDevice(pixels.topLeft()), at.toDevice(pixels.bottomRight())};
}

}  // namespace

void paintPixelGrid(QPainter& painter, const QRect& clip, const Placement& at, const QSize& image) {
  constexpr double closest = 8;
  if (at.zoom < closest) return;
  const QColor colour(128, 128, 128, 110);
  const QRect part = pixelsUnder(clip, at, image);
  const QPoint from = at.toDevice(part.topLeft()).toPoint();
  const QPoint to = at.toDevice(part.topLeft() + QPoint(part.width(), part.height())).toPoint();
  painter.save();
  painter.setClipRect(clip);
  for (int x = part.left(); x <= part.right() + 1; ++x)
    painter.fillRect(int(std::round(at.toDevice({double(x), 0}).x())), from.y(), 1,
                     to.y() - from.y(), colour);
  for (int y = part.top(); y <= part.bottom() + 1; ++y)
    painter.fillRect(from.x(), int(std::round(at.toDevice({0, double(y)}).y())), to.x() - from.x(),
                     1, colour);
  painter.restore();
}

void paintPixelMarks(QPainter& painter, const QRect& clip, const Placement& at,
                     const QPainterPath& outline) {
  if (outline.isEmpty()) return;
  constexpr double smallest = 9;
  const QRectF box = inDevice(at, outline.boundingRect());
  const double grow = std::max(0.0, (smallest - std::min(box.width(), box.height())) / 2) + 1;
  if (grow > 1) {
    paintOutline(painter, clip, around(box.adjusted(-grow, -grow, grow, grow)), Qt::SolidLine);
  } else {
    const QTransform toDevice(at.zoom, 0, 0, at.zoom, at.origin.x(), at.origin.y());
    paintOutline(painter, clip, toDevice.map(outline), Qt::SolidLine);
  }
}

void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region) {
  paintOutline(painter, clip, around(inDevice(at, region)), Qt::DashLine);
}

void paintWipe(QPainter& painter, int column, int height, double ratio) {
  painter.fillRect(column - 1, 0, 3, height, QColor(0, 0, 0, 128));
  painter.fillRect(column, 0, 1, height, Qt::white);
  const QPointF middle(column + 0.5, height / 2.0);
  const double radius = 11 * ratio;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::black, ratio));
  painter.setBrush(Qt::white);
  painter.drawEllipse(middle, radius, radius);
  painter.setBrush(Qt::black);
  for (const double side : {-1.0, 1.0})
    painter.drawPolygon(QPolygonF{middle + QPointF(side * 0.7 * radius, 0),
                                  middle + QPointF(side * 0.25 * radius, -0.35 * radius),
                                  middle + QPointF(side * 0.25 * radius, 0.35 * radius)});
  painter.restore();
}

}  // namespace hogelscope
