// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/image_marks.h"

#include <algorithm>

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

void paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit) {
  constexpr int parts = 4;
  constexpr int gap = 4;
  const QFontMetrics metrics(painter.font());
  QStringList numbers;
  int textWidth = metrics.horizontalAdvance(unit);
  for (int k = 0; k <= parts; ++k) {
    numbers << QString::number(map.errorAt(double(k) / parts), 'g', 4);
    textWidth = std::max(textWidth, metrics.horizontalAdvance(numbers.back()));
  }
  constexpr int barWidth = 12;
  const int line = metrics.height();
  const int height = std::min(area.height() - 4 * line, 260);
  if (height < (parts + 1) * line) return;
  const QRect ground(area.right() - barWidth - textWidth - 4 * gap,
                     area.center().y() - height / 2 - 2 * line, barWidth + textWidth + 3 * gap,
                     height + 3 * line);
  painter.fillRect(ground, QColor(0, 0, 0, 220));
  const QRect bar(ground.left() + gap, ground.top() + 2 * line, barWidth, height);
  for (int y = 0; y < height; ++y) {
    const auto [red, green, blue] = map.colourAt(1 - double(y) / (height - 1));
    painter.fillRect(bar.left(), bar.top() + y, barWidth, 1, QColor(red, green, blue));
  }
  painter.setPen(Qt::white);
  const int left = bar.right() + gap;
  painter.drawText(QRect(ground.left(), ground.top(), ground.width() - gap, line), Qt::AlignRight,
                   unit);
  for (int k = 0; k <= parts; ++k)
    painter.drawText(QRect(left, bar.bottom() - k * height / parts - line / 2, textWidth, line),
                     int(Qt::AlignRight) | int(Qt::AlignVCenter), numbers[k]);
}

}  // namespace hogelscope
