// SPDX-License-Identifier: BSD-3-Clause
// What is painted on an image.
#include "gui/view/image_marks.h"

#include <algorithm>
#include <utility>

namespace hogelscope {

namespace {

/// White on black: seen on any image.
void paintFrame(QPainter& painter, const QRect& clip, const QRect& frame, Qt::PenStyle style) {
  painter.save();
  painter.setClipRect(clip);
  for (const auto& [colour, width, line] :
       {std::tuple(Qt::black, 3, Qt::SolidLine), std::tuple(Qt::white, 1, style)}) {
    painter.setPen(QPen(colour, width, line));
    painter.drawRect(frame);
  }
  painter.restore();
}

QRect inDevice(const Placement& at, const QRect& pixels) {
  return {at.toDevice(pixels.topLeft()).toPoint(),
          at.toDevice(pixels.bottomRight() + QPoint(1, 1)).toPoint()};
}

}  // namespace

void paintPixelMark(QPainter& painter, const QRect& clip, const Placement& at,
                    const QPoint& pixel) {
  constexpr int smallest = 9;
  const QRect drawn = inDevice(at, {pixel, QSize(1, 1)});
  const int grow = std::max(0, (smallest - drawn.width()) / 2) + 1;
  paintFrame(painter, clip, drawn.adjusted(-grow, -grow, grow - 1, grow - 1), Qt::SolidLine);
}

void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region) {
  paintFrame(painter, clip, inDevice(at, region).adjusted(-1, -1, 0, 0), Qt::DashLine);
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
  painter.fillRect(ground, QColor(0, 0, 0, 170));
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
