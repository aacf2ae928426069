// SPDX-License-Identifier: BSD-3-Clause
#include "chart/stability_map.h"

#include <QImage>
#include <QPainterPath>
#include <algorithm>

#include "chart/outcome_legend.h"
#include "core/base/axis.h"

namespace hogelscope {

namespace {

/// Distances in points.
constexpr double leftMargin = 62;
constexpr double topMargin = 50;
constexpr double rightMargin = 14;
constexpr double betweenMaps = 16;
constexpr double belowRow = 50;  // tick labels, axis name, the next row
constexpr double legendHeight = 66;

const OutcomeWords& words() {
  static const OutcomeWords all{
      "right: every pixel has its ray, to 0.001 px",
      "no ray: some pixels have none, and the method says so",
      "inexact: some are more than 0.001 px off, but nearer than at first",
      "diverged: some are no nearer than at first, or not a number",
      "wrong root: some have another pixel's ray, or one where there is none"};
  return all;
}

/// The place of a map on the paper.
struct MapFrame {
  QRectF area;
  double reach;  ///< the largest coefficient
  double cell;   ///< the size of a map's cell, in coefficients

  [[nodiscard]] QPointF at(double x, double y) const {
    const double half = reach + cell / 2;  // a lens is at its cell's centre
    return {area.left() + area.width() * (x + half) / (2 * half),
            area.bottom() - area.height() * (y + half) / (2 * half)};
  }
};

void paintCells(QPainter& painter, const MapFrame& frame, int side,
                const std::vector<LensOutcomes>& lenses) {
  QImage image(side, side, QImage::Format_RGB32);
  auto lens = lenses.begin();
  for (int row = side - 1; row >= 0; --row)
    for (int column = 0; column < side; ++column, ++lens)
      image.setPixel(column, row, colourOf(lens->worst()));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.drawImage(frame.area, image);
}

void paintFoldLine(QPainter& painter, const MapFrame& frame,
                   const std::vector<std::vector<Vec2>>& pieces) {
  QPainterPath path;
  for (const std::vector<Vec2>& piece : pieces) {
    path.moveTo(frame.at(piece.front().x, piece.front().y));
    for (const Vec2& p : piece) path.lineTo(frame.at(p.x, p.y));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::white, 3.2));
  painter.drawPath(path);
  painter.setPen(QPen(Qt::black, 1.4));
  painter.drawPath(path);
}

/// Paints five ticks along each axis; name and numbers of y only at the row's first map.
void paintAxes(QPainter& painter, const MapFrame& frame, const LensPlane& plane, bool isFirst) {
  constexpr double length = 4;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 1));
  painter.drawRect(frame.area);
  const double bottom = frame.area.bottom();
  bool hasNumber = false;
  for (const Tick& tick : linearTicks({-frame.reach, frame.reach}, 5)) {
    hasNumber = !hasNumber;  // every second one along x, for space
    const double x = frame.at(tick.value, 0).x();
    const double y = frame.at(0, tick.value).y();
    const QString number = QString::fromStdString(tick.text);
    painter.drawLine(QPointF(x, bottom), QPointF(x, bottom + length));
    painter.drawLine(QPointF(frame.area.left() - length, y), QPointF(frame.area.left(), y));
    // Keeps the outer numbers within the map, so that they do not overlap the next map's.
    const double middle = std::clamp(x, frame.area.left() + 14, frame.area.right() - 10);
    if (hasNumber)
      painter.drawText(QRectF(middle - 30, bottom + length + 1, 60, 15), Qt::AlignCenter, number);
    if (isFirst)
      painter.drawText(QRectF(frame.area.left() - 46, y - 8, 40, 16),
                       Qt::AlignRight | Qt::AlignVCenter, number);
  }
  QFont italic = painter.font();
  italic.setItalic(true);
  painter.save();
  painter.setFont(italic);
  painter.drawText(QRectF(frame.area.left(), frame.area.bottom() + 20, frame.area.width(), 16),
                   Qt::AlignCenter, QString::fromStdString(plane.axes[0]));
  if (isFirst)
    painter.drawText(QRectF(4, frame.area.center().y() - 8, 30, 16), Qt::AlignCenter,
                     QString::fromStdString(plane.axes[1]));
  painter.restore();
}

void paintLegend(QPainter& painter, const QRectF& area) {
  paintOutcomeLegend(painter, area, words());
  const QRectF line = legendLine(area, int(outcomeCount));
  painter.setPen(QPen(Qt::black, 1.4));
  painter.drawLine(line.topLeft() + QPointF(0, 8), line.topLeft() + QPointF(22, 8));
  painter.drawText(line.adjusted(32, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   "fold line: beyond it the lens folds within the picture");
}

}  // namespace

QSize stabilityMapsSize() {
  return {1000, 572};
}

void paintStabilityMaps(QPainter& painter, const QSizeF& size, const std::vector<LensMap>& maps) {
  const auto& methods = inverseMethods();
  const auto columns = double(methods.size());
  const double side =
      (size.width() - leftMargin - rightMargin - (columns - 1) * betweenMaps) / columns;
  paintTitle(painter, QRectF(0, 4, size.width(), 18),
             "The worst pixel of a 60° picture, over the coefficients of its lens, for each way to "
             "invert it");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double left = leftMargin + double(m) * (side + betweenMaps);
    paintTitle(painter, QRectF(left, topMargin - 22, side, 18), titleOf(methods[m]));
    for (std::size_t p = 0; p < maps.size(); ++p) {
      const double top = topMargin + double(p) * (side + belowRow);
      const LensPlane& plane = maps[p].plane;
      const MapFrame frame{QRectF(left, top, side, side), plane.reach(), 1.0 / plane.stepsPerUnit};
      paintCells(painter, frame, plane.side(), maps[p].outcomes[m]);
      paintFoldLine(painter, frame, maps[p].foldLine);
      paintAxes(painter, frame, plane, m == 0);
    }
  }
  paintLegend(painter, QRectF(leftMargin, size.height() - legendHeight,
                              size.width() - leftMargin - rightMargin, legendHeight));
}

}  // namespace hogelscope
