// SPDX-License-Identifier: BSD-3-Clause
#include "picture/labels.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis.h"

namespace hogelscope {

void paintGround(QPainter& painter, const QRect& box, const QColor& colour) {
  constexpr int radius = 4;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(box, radius, radius);
  painter.restore();
}

void paintText(QPainter& painter, const QRect& area, Qt::Alignment corner, const QString& text,
               const LabelColours& colours, const QColor& mark, int side) {
  if (text.isEmpty()) return;
  constexpr int margin = 4;
  const QRect inner = area.adjusted(margin, margin, -margin, -margin);
  QRect box = painter.boundingRect(inner, int(corner) | int(Qt::TextWordWrap), text);
  box = box.adjusted(-margin, -margin / 2, margin, margin / 2);
  const int square = mark.isValid() ? side : 0;
  const int indent = mark.isValid() ? square + margin : 0;
  const bool isRight = corner.testFlag(Qt::AlignRight);
  paintGround(painter, box.adjusted(isRight ? -indent : 0, 0, isRight ? 0 : indent, 0),
              colours.ground);
  if (!isRight) box.translate(indent, 0);
  if (mark.isValid())
    painter.fillRect(box.left() + margin - indent, box.center().y() - square / 2, square, square,
                     mark);
  painter.setPen(colours.text);
  painter.drawText(box, int(Qt::AlignCenter) | int(Qt::TextWordWrap), text);
}

int paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit,
               const LabelColours& colours) {
  constexpr int gap = 4;
  constexpr int barWidth = 12;
  const int line = painter.fontMetrics().height();
  const int height = std::min(area.height() - 4 * line, 260);
  if (height < 5 * line) return area.right();
  const Axis axis{map.errorAt(0), map.errorAt(1), 0, double(height)};
  const std::vector<Tick> ticks = linearTicks(axis, 5);
  int textWidth = painter.fontMetrics().horizontalAdvance(unit);
  for (const Tick& tick : ticks)
    textWidth = std::max(
        textWidth, painter.fontMetrics().horizontalAdvance(QString::fromStdString(tick.text)));
  const QRect ground(area.right() - barWidth - textWidth - 4 * gap,
                     area.bottom() - gap - height - 3 * line, barWidth + textWidth + 3 * gap,
                     height + 3 * line);
  paintGround(painter, ground, colours.ground);
  const QRect bar(ground.left() + gap, ground.top() + 2 * line, barWidth, height);
  for (int y = 0; y < height; ++y) {
    const auto [red, green, blue] = map.colourAt(1 - double(y) / (height - 1));
    painter.fillRect(bar.left(), bar.top() + y, barWidth, 1, QColor(red, green, blue));
  }
  painter.setPen(colours.text);
  painter.drawText(QRect(ground.left(), ground.top(), ground.width() - gap, line), Qt::AlignRight,
                   unit);
  for (const Tick& tick : ticks) {
    const int y = bar.bottom() - int(std::round(map.placeOf(tick.value) * (height - 1)));
    painter.drawText(QRect(bar.right() + gap, y - line / 2, textWidth, line),
                     int(Qt::AlignRight) | int(Qt::AlignVCenter),
                     QString::fromStdString(tick.text));
  }
  return ground.left();
}

}  // namespace hogelscope
