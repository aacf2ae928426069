// SPDX-License-Identifier: BSD-3-Clause
#include "chart/stability_charts.h"

#include <QImage>
#include <QPainterPath>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/axis.h"

namespace hogelscope {

namespace {

using OutcomeWords = std::array<const char*, outcomeCount>;

// Of both charts, in points.
constexpr double topMargin = 50;
constexpr double between = 16;

/// Returns a colour, light for right outcomes and dark for wrong ones, distinct for colour-blind
/// readers and in greyscale.
QRgb colourOf(Outcome outcome) {
  constexpr std::array<QRgb, outcomeCount> colours{0xff79bfe8, 0xffffffff, 0xfff7dd4a, 0xffd55e00,
                                                   0xff3b1f5b};
  return colours[std::size_t(outcome)];
}

/// Returns the place of a line of the legend, which has two columns of three lines and is 66 points
/// high.
QRectF legendLine(const QRectF& area, int index) {
  constexpr int lines = 3;
  constexpr double step = 21;
  const double width = area.width() / 2;
  return {area.left() + index / lines * width, area.top() + index % lines * step, width, 16};
}

/// Paints a sample and a text for each outcome, in their order.
void paintOutcomeLegend(QPainter& painter, const QRectF& area, const OutcomeWords& words) {
  for (int k = 0; k < int(outcomeCount); ++k) {
    const QRectF line = legendLine(area, k);
    painter.setPen(QPen(Qt::black, 0.8));
    painter.setBrush(QColor(colourOf(Outcome(k))));
    painter.drawRect(QRectF(line.topLeft() + QPointF(0, 1), QSizeF(22, 14)));
    painter.setPen(Qt::black);
    painter.drawText(line.adjusted(32, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     words[std::size_t(k)]);
  }
}

/// Paints bold text in the middle of the area.
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

// Of the maps, in points.
constexpr double leftMargin = 62;
constexpr double rightMargin = 14;
constexpr double belowRow = 50;  // tick labels, axis name, the next row
constexpr double mapLegendHeight = 66;

constexpr OutcomeWords mapWords{
    "right: every pixel has its ray, to 0.001 px",
    "no ray: some pixels have none, and the method says so",
    "inexact: some are more than 0.001 px off, but nearer than at first",
    "diverged: some are no nearer than at first, or not a number",
    "wrong root: some have another pixel's ray, or one where there is none"};

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

void paintMapLegend(QPainter& painter, const QRectF& area) {
  paintOutcomeLegend(painter, area, mapWords);
  const QRectF line = legendLine(area, int(outcomeCount));
  painter.setPen(QPen(Qt::black, 1.4));
  painter.drawLine(line.topLeft() + QPointF(0, 8), line.topLeft() + QPointF(22, 8));
  painter.drawText(line.adjusted(32, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   "fold line: beyond it the lens folds within the picture");
}

// Of the pictures of lenses, in points.
constexpr double margin = 14;
constexpr double nameHeight = 22;
constexpr double captionHeight = 26;
constexpr double pictureLegendHeight = 76;
constexpr double picturesWidth = 1000;

constexpr OutcomeWords pictureWords{"right: the pixel's own ray, to 0.001 px",
                                    "no ray: the pixel has none, and the method says so",
                                    "inexact: more than 0.001 px off, but nearer than at first",
                                    "diverged: no nearer than at first, or not a number",
                                    "wrong root: another pixel's ray, or one where there is none"};

double pictureWidth() {
  const auto columns = double(inverseMethods().size());
  return (picturesWidth - 2 * margin - (columns - 1) * between) / columns;
}

/// Returns a height with the camera's aspect ratio, within limits.
double pictureHeight(const LensKey& lens) {
  return pictureWidth() * std::clamp(double(lens.res[1]) / lens.res[0], 0.25, 1.5);
}

std::size_t endOf(const Stability& stability, std::size_t first) {
  return std::min(stability.lenses.size(), first + mostLensPictures);
}

QImage pictureOf(const LensOutcomes& outcomes) {
  const int side = int(std::lround(std::sqrt(double(outcomes.each.size()))));
  QImage image(side, side, QImage::Format_RGB32);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      image.setPixel(x, y,
                     colourOf(outcomes.each[std::size_t(y) * std::size_t(side) + std::size_t(x)]));
  return image;
}

/// Returns "all right", or the worst outcome and its share.
QString captionOf(const LensOutcomes& outcomes) {
  const Outcome worst = outcomes.worst();
  if (worst == Outcome::right) return "all right";
  const double share = double(outcomes[worst]) / double(outcomes.points());
  return QString::number(100 * share, 'f', 1) + " % " +
         QString::fromStdString(outcomeNames()[std::size_t(worst)]).replace('_', ' ');
}

}  // namespace

QSize stabilityMapsSize() {
  return {1000, 572};
}

void paintStabilityMaps(QPainter& painter, const QSizeF& size, const std::vector<LensMap>& maps) {
  const auto& methods = inverseMethods();
  const auto columns = double(methods.size());
  const double side = (size.width() - leftMargin - rightMargin - (columns - 1) * between) / columns;
  paintTitle(painter, QRectF(0, 4, size.width(), 18),
             "The worst pixel of a 60° picture, over the coefficients of its lens, for each way to "
             "invert it");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double left = leftMargin + double(m) * (side + between);
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
  paintMapLegend(painter, QRectF(leftMargin, size.height() - mapLegendHeight,
                                 size.width() - leftMargin - rightMargin, mapLegendHeight));
}

QSize lensPicturesSize(const Stability& stability, std::size_t first) {
  double height = topMargin + pictureLegendHeight;
  for (std::size_t k = first; k < endOf(stability, first); ++k)
    height += nameHeight + pictureHeight(stability.lenses[k].key) + captionHeight;
  return {int(picturesWidth), int(std::ceil(height))};
}

void paintLensPictures(QPainter& painter, const QSizeF& size, const Stability& stability,
                       std::size_t first) {
  const auto& methods = inverseMethods();
  const double across = pictureWidth();
  const auto left = [&](std::size_t m) { return margin + double(m) * (across + between); };
  paintTitle(painter, QRectF(0, 4, size.width(), 18),
             "Where in the picture of each lens each way to invert it holds");
  for (std::size_t m = 0; m < methods.size(); ++m)
    paintTitle(painter, QRectF(left(m), topMargin - 24, across, 18), titleOf(methods[m]));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.setBrush(Qt::NoBrush);
  double y = topMargin;
  for (std::size_t k = first; k < endOf(stability, first); ++k) {
    const double height = pictureHeight(stability.lenses[k].key);
    const QString name =
        painter.fontMetrics().elidedText(QString::fromStdString(stability.lenses[k].name),
                                         Qt::ElideRight, int(picturesWidth - 2 * margin));
    painter.drawText(QRectF(margin, y, picturesWidth - 2 * margin, nameHeight),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
    y += nameHeight;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const QRectF area(left(m), y, across, height);
      painter.drawImage(area, pictureOf(stability.outcomes[k][m]));
      painter.drawRect(area);
      painter.drawText(QRectF(left(m), area.bottom() + 2, across, 16), Qt::AlignCenter,
                       captionOf(stability.outcomes[k][m]));
    }
    y += height + captionHeight;
  }
  paintOutcomeLegend(painter,
                     QRectF(margin, y + 4, picturesWidth - 2 * margin, pictureLegendHeight),
                     pictureWords);
}

}  // namespace hogelscope
