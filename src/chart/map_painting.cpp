// SPDX-License-Identifier: BSD-3-Clause
#include "chart/map_painting.h"

#include <QFontMetricsF>
#include <QImage>

#include <algorithm>

#include "chart/plot_painting.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

/// Returns the cells as an image, the lowest row at the bottom.
QImage cellsOf(const MapPlot& plot) {
  QImage image(plot.columns, plot.rows(), QImage::Format_RGB32);
  for (int row = 0; row < plot.rows(); ++row)
    for (int column = 0; column < plot.columns; ++column) {
      const double value =
          plot.values[std::size_t(row) * std::size_t(plot.columns) + std::size_t(column)];
      image.setPixelColor(
          column, plot.rows() - 1 - row,
          shadeColour((value - plot.shades[0]) / (plot.shades[1] - plot.shades[0])));
    }
  return image;
}

/// Strokes a line that is seen on every colour: white over black.
void stroke(QPainter& painter, const QLineF& line, Qt::PenStyle style) {
  QPen pen(QColor(0, 0, 0, 130), 2.6, style, Qt::FlatCap);
  painter.setPen(pen);
  painter.drawLine(line);
  pen.setColor(Qt::white);
  pen.setWidthF(1.2);
  painter.setPen(pen);
  painter.drawLine(line);
}

/// Draws a dot that is seen on every colour.
void drawDot(QPainter& painter, const QPointF& at) {
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(QColor(0xff, 0x9a, 0x2e));
  painter.drawEllipse(at, 5, 5);
  painter.setBrush(Qt::NoBrush);
}

/// Writes a name to the right of a place, or to its left where there is no room; on dark ground, so
/// that lines below do not run through it.
void writeName(QPainter& painter, const QRectF& area, const QPointF& at, const QString& name) {
  if (name.isEmpty()) return;
  constexpr double gap = 6;
  const QFontMetricsF metrics(painter.font());
  const double width = metrics.horizontalAdvance(name);
  const bool isLeft = at.x() + gap + width > area.right();
  const double left = isLeft ? at.x() - gap - width : at.x() + gap;
  const double top = std::clamp(at.y(), area.top(), area.bottom() - metrics.height());
  const QRectF place(std::max(left, area.left()), top, width, metrics.height());
  painter.fillRect(place.adjusted(-2, 0, 2, 0), QColor(0, 0, 0, 150));
  painter.setPen(Qt::white);
  painter.drawText(place, Qt::AlignCenter, name);
}

}  // namespace

void paintMap(QPainter& painter, const QSizeF& size, const MapPlot& plot,
              const ChartColours& colours) {
  const double text = painter.fontMetrics().height();
  const QRectF area(3.2 * text, 0.8 * text, size.width() - 7.2 * text, size.height() - 3.6 * text);
  if (plot.columns == 0 || area.width() < text || area.height() < text) return;
  const Axis across{plot.across[0], plot.across[1], area.left(), area.right()};
  const Axis up{plot.up[0], plot.up[1], area.bottom(), area.top()};
  painter.setRenderHint(QPainter::SmoothPixmapTransform, true);
  painter.drawImage(area, cellsOf(plot));
  const auto place = [&](const std::array<double, 2>& at) {
    return QPointF(across.at(at[0]), up.at(at[1]));
  };
  for (const double level : plot.contours)
    for (const auto& [from, to] : contourOf(plot, level))
      stroke(painter, {place(from), place(to)}, Qt::SolidLine);
  for (const auto& [from, to, name] : plot.lines)
    if (from == to && plot.up[0] < to[1] && to[1] < plot.up[1])
      drawDot(painter, place(to));
    else
      stroke(painter, {place(from), place(to)}, Qt::DashLine);
  for (const auto& [from, to, name] : plot.lines)
    writeName(painter, area, place(to) + QPointF(0, 4), QString::fromStdString(name));
  painter.setPen(colours.text2);
  std::vector<Tick> ticks = plot.ticks.empty()
                                ? linearTicks(across, std::max(2, int(area.width() / (5 * text))))
                                : plot.ticks;
  std::ranges::sort(ticks, {}, &Tick::value);
  double free = area.left() - 2 * text;
  for (const Tick& tick : ticks) {
    const double x = across.at(tick.value);
    const QString words = QString::fromStdString(tick.text);
    const double half = painter.fontMetrics().horizontalAdvance(words) / 2.0;
    if (x - half < free) continue;
    painter.drawText(QRectF(x - 100, area.bottom() + 2, 200, text), Qt::AlignCenter, words);
    free = x + half + 0.5 * text;
  }
  for (const Tick& tick : linearTicks(up, std::max(2, int(area.height() / (2 * text)))))
    painter.drawText(QRectF(0, up.at(tick.value) - text, area.left() - 5, 2 * text),
                     Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(tick.text));
  painter.drawText(QRectF(0, area.bottom() + 1.3 * text, size.width(), text), Qt::AlignCenter,
                   QString::fromStdString(plot.titleAcross));
  painter.save();
  painter.translate(0.5 * text, area.center().y());
  painter.rotate(-90);
  painter.drawText(QRectF(-300, -0.5 * text, 600, text), Qt::AlignCenter,
                   QString::fromStdString(plot.titleUp));
  painter.restore();
  paintColourBar(painter, {area.right() + 0.8 * text, area.top(), 8, area.height()},
                 QString::fromStdString(rounded(plot.shades[0], 1)),
                 QString::fromStdString(rounded(plot.shades[1], 1)), colours.text2);
}

}  // namespace hogelscope
