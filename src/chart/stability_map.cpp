// SPDX-License-Identifier: BSD-3-Clause
// The maps of stability.png.
#include "chart/stability_map.h"

#include <QImage>
#include <QPainterPath>

namespace hogelscope {

namespace {

/// Distances in points.
constexpr double leftMargin = 62;
constexpr double topMargin = 50;
constexpr double rightMargin = 14;
constexpr double betweenMaps = 16;
constexpr double belowRow = 50;  // tick labels, axis name, the next row
constexpr double legendHeight = 66;

/// Light where all is well, dark where it is not; told apart by the colour-blind and in grey.
QRgb colourOf(Outcome outcome) {
  constexpr std::array<QRgb, outcomeCount> colours{0xff79bfe8, 0xffffffff, 0xfff7dd4a, 0xffd55e00,
                                                   0xff3b1f5b};
  return colours[std::size_t(outcome)];
}

QString wordsFor(Outcome outcome) {
  static const std::array<QString, outcomeCount> words{
      "right: every pixel has its ray, to 0.001 px",
      "no ray: some pixels have none, and the method says so",
      "inexact: some are more than 0.001 px off, but nearer than at first",
      "diverged: some are no nearer than at first, or not a number",
      "wrong root: some have another pixel's ray, or one where there is none"};
  return words[std::size_t(outcome)];
}

/// Where a map's lenses are on the paper.
struct MapFrame {
  QRectF area;
  double reach;  ///< of the coefficients
  double cell;   ///< of the map, in coefficients

  [[nodiscard]] QPointF at(double x, double y) const {
    const double half = reach + cell / 2;  // a lens is its cell's middle
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

QString tickText(double value) {
  return QString::number(value).replace('-', QChar(0x2212));
}

/// Five ticks along each axis; names and numbers of y only where it is the row's first map.
void paintAxes(QPainter& painter, const MapFrame& frame, const LensPlane& plane, bool isFirst) {
  constexpr double tick = 4;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 1));
  painter.drawRect(frame.area);
  for (int k = -2; k <= 2; ++k) {
    const double value = k * frame.reach / 2;
    const QPointF below = frame.at(value, -frame.reach);
    const QPointF left = frame.at(-frame.reach, value);
    const double bottom = frame.area.bottom();
    painter.drawLine(QPointF(below.x(), bottom), QPointF(below.x(), bottom + tick));
    painter.drawLine(QPointF(frame.area.left() - tick, left.y()),
                     QPointF(frame.area.left(), left.y()));
    // The outer numbers keep within the map, so that the next one's have room.
    const auto align = k == 0 ? Qt::AlignHCenter : k < 0 ? Qt::AlignLeft : Qt::AlignRight;
    if (k % 2 == 0)
      painter.drawText(QRectF(below.x() - 30 - 15 * k, bottom + tick + 1, 60, 15),
                       align | Qt::AlignVCenter, tickText(value));
    if (k % 2 == 0 && isFirst)
      painter.drawText(QRectF(frame.area.left() - 46, left.y() - 8, 40, 16),
                       Qt::AlignRight | Qt::AlignVCenter, tickText(value));
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

void paintTitle(QPainter& painter, const QRectF& area, const QString& title) {
  QFont bold = painter.font();
  bold.setBold(true);
  painter.save();
  painter.setFont(bold);
  painter.drawText(area, Qt::AlignCenter, title);
  painter.restore();
}

QString titleOf(const InverseMethod& method) {
  const QStringList words = QString::fromStdString(method.name).split(' ');
  if (words[0] == "OpenCV") return "OpenCV, " + words[1] + " iterations";
  if (words[0] == "Newton") return "Newton, " + words[1] + " steps";
  return "certified (ours)";
}

/// Two columns of samples, the fold line's too.
void paintLegend(QPainter& painter, const QRectF& area) {
  constexpr int rows = 3;
  constexpr double step = 21;
  const double width = area.width() / 2;
  const auto place = [&](int index) {
    const int column = index / rows;
    const int row = index % rows;
    return QPointF(area.left() + column * width, area.top() + row * step);
  };
  const auto label = [&](int index, const QString& text) {
    painter.setPen(Qt::black);
    painter.drawText(QRectF(place(index) + QPointF(32, 0), QSizeF(width - 34, 16)),
                     Qt::AlignLeft | Qt::AlignVCenter, text);
  };
  for (int k = 0; k < int(outcomeCount); ++k) {
    painter.setPen(QPen(Qt::black, 0.8));
    painter.setBrush(QColor(colourOf(Outcome(k))));
    painter.drawRect(QRectF(place(k) + QPointF(0, 1), QSizeF(22, 14)));
    label(k, wordsFor(Outcome(k)));
  }
  const int last = int(outcomeCount);
  painter.setPen(QPen(Qt::black, 1.4));
  painter.drawLine(place(last) + QPointF(0, 8), place(last) + QPointF(22, 8));
  label(last, "fold line: beyond it the lens folds within the picture");
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
