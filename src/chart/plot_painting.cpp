// SPDX-License-Identifier: BSD-3-Clause
#include "chart/plot_painting.h"

#include <QObject>
#include <cmath>

#include "core/base/colour_map.h"

namespace hogelscope {

namespace {

constexpr double legendLine = 18;

PlotBox boxOf(const Plot& plot, const QSizeF& size) {
  const double legend = plot.series.size() > 1 ? legendLine * double(plot.series.size()) : 0;
  return {size.width(), size.height(), 44 + legend, 12};
}

QPointF pointAt(const PlotArea& area, const Plot::Point& point, std::size_t series) {
  const auto [x, y] = area.placeOf(point, series);
  return {x, y};
}

void paintMark(QPainter& painter, const QPointF& at, double radius, std::size_t series) {
  const std::vector<double> corners = markCorners(series);
  if (corners.empty()) return painter.drawEllipse(at, radius, radius);
  QPolygonF polygon;
  for (std::size_t k = 0; k < corners.size(); k += 2)
    polygon << at + radius * QPointF(corners[k], corners[k + 1]);
  painter.drawPolygon(polygon);
}

void paintFrame(QPainter& painter, const Plot& plot, const PlotArea& area) {
  const QRectF frame(QPointF(area.across.from, area.up.to), QPointF(area.across.to, area.up.from));
  const QColor grid(221, 221, 221);
  const auto label = [&painter](const QRectF& box, int flags, const std::string& text) {
    painter.setPen(Qt::black);
    painter.drawText(box, flags | Qt::AlignVCenter, QString::fromStdString(text));
  };
  for (const Tick& tick : ticksAcross(plot, area.across)) {
    const double x = area.across.at(tick.value);
    painter.setPen(grid);
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    label({x - 40, frame.bottom() + 3, 80, 16}, Qt::AlignHCenter, tick.text);
  }
  for (const Tick& tick : ticksUp(area.up)) {
    const double y = area.up.at(tick.value);
    painter.setPen(grid);
    painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
    label({18, y - 8, frame.left() - 23, 16}, Qt::AlignRight, tick.text);
  }
  painter.setPen(QColor(136, 136, 136));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame);
  if (area.hasIdentical)
    label({0, 16, frame.left() - 5, 16}, Qt::AlignRight, QObject::tr("identical").toStdString());
  label({frame.left(), frame.bottom() + 20, frame.width(), 16}, Qt::AlignHCenter, plot.titleAcross);
  painter.save();
  painter.translate(10, frame.center().y());
  painter.rotate(-90);
  label({-100, -8, 200, 16}, Qt::AlignHCenter, plot.titleUp);
  painter.restore();
}

void paintPoints(QPainter& painter, const Plot& plot, const PlotArea& area,
                 std::optional<std::size_t> selected) {
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const Plot::Point& point : plot.series[k].points) {
      painter.setPen(QPen(Qt::white, 0.8));
      painter.setBrush(QColor(seriesColour(k)));
      paintMark(painter, pointAt(area, point, k), plot.series[k].radius, k);
    }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 2));
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const Plot::Point& point : plot.series[k].points)
      if (point.row == selected) {
        const double radius = plot.series[k].radius + 3;
        painter.drawEllipse(pointAt(area, point, k), radius, radius);
      }
}

void paintLegend(QPainter& painter, const Plot& plot, const PlotArea& area) {
  double y = area.up.from + 50;
  for (std::size_t k = 0; k < plot.series.size(); ++k, y += legendLine) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(seriesColour(k)));
    paintMark(painter, {area.across.from + 6, y}, 4, k);
    painter.setPen(Qt::black);
    const QRectF box(area.across.from + 18, y - 8, area.across.to - area.across.from - 18, 16);
    painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(QString::fromStdString(plot.series[k].name),
                                                      Qt::ElideMiddle, int(box.width())));
  }
}

}  // namespace

void paintPlot(QPainter& painter, const QSizeF& size, const Plot& plot,
               std::optional<std::size_t> selected) {
  const PlotArea area = areaOf(plot, boxOf(plot, size));
  painter.save();
  QFont font = painter.font();
  font.setPixelSize(12);
  painter.setFont(font);
  paintFrame(painter, plot, area);
  paintPoints(painter, plot, area, selected);
  if (plot.series.size() > 1) paintLegend(painter, plot, area);
  painter.restore();
}

std::optional<std::size_t> rowAt(const Plot& plot, const QPointF& place, const QSizeF& size) {
  constexpr double farthest = 8;  // points
  const PlotArea area = areaOf(plot, boxOf(plot, size));
  std::optional<std::size_t> row;
  double least = farthest;
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const Plot::Point& point : plot.series[k].points) {
      const QPointF way = pointAt(area, point, k) - place;
      if (const double distance = std::hypot(way.x(), way.y()); distance <= least) {
        least = distance;
        row = point.row;
      }
    }
  return row;
}

std::optional<QPointF> placeOf(const Plot& plot, std::size_t row, const QSizeF& size) {
  const PlotArea area = areaOf(plot, boxOf(plot, size));
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const Plot::Point& point : plot.series[k].points)
      if (point.row == row) return pointAt(area, point, k);
  return std::nullopt;
}

}  // namespace hogelscope
