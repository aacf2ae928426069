// SPDX-License-Identifier: BSD-3-Clause
#include "chart/plot_painting.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

namespace {

bool hasLegend(const Plot& plot) {
  return !plot.hasCurves && plot.series.size() > 1;
}

/// Returns the margins for text of a size; names stand at the right of curves, and the colour bar
/// at the right of maps.
PlotBox boxOf(const Plot& plot, const QSizeF& size, double text) {
  const double line = 1.5 * text;
  const bool isWide = plot.hasCurves || plot.shades;
  return {
      size.width(), size.height(), (hasLegend(plot) ? 3 : 2) * line + 4, isWide ? 5 * text : text,
      3.7 * text,   1.8 * line};
}

PlotArea areaOf(const Plot& plot, const QSizeF& size, double text) {
  return areaOf(plot, boxOf(plot, size, text));
}

QPointF pointAt(const PlotArea& area, const Plot::Point& point, std::size_t series) {
  const auto [x, y] = area.placeOf(point, series);
  return {x, y};
}

/// A plot's painter, with what its parts share.
struct PlotPainter {
  QPainter& painter;
  QSizeF size;
  const Plot& plot;
  const ChartColours& colours;
  double text = painter.font().pixelSize();
  PlotArea area = areaOf(plot, size, text);

  [[nodiscard]] QColor colourOf(std::size_t series) const {
    return colours.series.at(series % colours.series.size());
  }
  [[nodiscard]] QColor shadeOf(double value) const {
    if (std::isinf(value)) return colours.text;  // identical
    return shadeColour((value - plot.shades->low) / (plot.shades->high - plot.shades->low));
  }
  void write(const QRectF& box, int flags, const std::string& words, const QColor& colour) const {
    painter.setPen(colour);
    painter.drawText(box, flags | Qt::AlignVCenter, QString::fromStdString(words));
  }

  void paintFrame() const {
    const double left = area.across.from, right = area.across.to, bottom = area.up.from;
    const double line = 1.5 * text;
    for (const Tick& tick : ticksUp(area.up)) {
      const double y = area.up.at(tick.value);
      painter.setPen(colours.grid);
      painter.drawLine(QPointF(left, y), QPointF(right, y));
      write({0, y - text, left - 6, 2 * text}, Qt::AlignRight, tick.text, colours.text2);
    }
    for (const Tick& tick : ticksAcross(plot, area.across)) {
      const double x = area.across.at(tick.value);
      painter.setPen(colours.grid);
      if (plot.panel <= 0) painter.drawLine(QPointF(x, area.up.to), QPointF(x, bottom));
      painter.setPen(colours.line);
      painter.drawLine(QPointF(x, bottom), QPointF(x, bottom + 4));
      write({x - 40, bottom + 4, 80, line}, Qt::AlignHCenter, tick.text, colours.text2);
    }
    painter.setPen(colours.line);
    painter.drawLine(QPointF(left, bottom), QPointF(right, bottom));
    if (area.hasIdentical)
      write({0, area.up.to - 28, left - 6, 2 * text}, Qt::AlignRight,
            QObject::tr("same").toStdString(), colours.text2);
    write({left, bottom + 4 + 0.9 * line, right - left, line},
          plot.panel > 0 ? Qt::AlignHCenter : Qt::AlignRight, plot.titleAcross, colours.text2);
    painter.save();
    QFont bold = painter.font();
    bold.setWeight(QFont::Medium);
    painter.setFont(bold);
    write({text, 0.2 * line, size.width() - text, line}, Qt::AlignLeft, plot.titleUp, colours.text);
    painter.restore();
    if (plot.panel <= 0) return;
    const double x = area.across.at(-plot.panel / 2);
    painter.fillRect(QRectF(x, area.up.at(0) - 2, area.across.at(plot.panel / 2) - x, 4),
                     colours.text);
  }

  /// Paints the lines of the limit and of the mark, which are no data.
  void paintLines() const {
    painter.setPen(QPen(colours.accent, 1, Qt::DashLine));
    if (plot.limit) {
      const double y = area.up.at(*plot.limit);
      painter.drawLine(QPointF(area.across.from, y), QPointF(area.across.to, y));
    }
    if (!plot.mark || *plot.mark < area.across.low || *plot.mark > area.across.high) return;
    const double x = area.across.at(*plot.mark);
    painter.setPen(QPen(colours.text2, 1, Qt::DashLine));
    painter.drawLine(QPointF(x, area.up.from), QPointF(x, area.up.to));
    const bool isRight = x < (area.across.from + area.across.to) / 2;
    write({isRight ? x + 4 : x - 204, area.up.to, 200, 1.5 * text},
          isRight ? Qt::AlignLeft : Qt::AlignRight, plot.markName, colours.text2);
  }

  /// Paints a series' curve over the band of its intervals, and its name at the end.
  void paintCurve(std::size_t k) const {
    QPolygonF line;
    for (const Plot::Point& point : plot.series[k].points) line << pointAt(area, point, k);
    if (line.isEmpty()) return;
    QColor light = colourOf(k);
    light.setAlphaF(0.16F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(light);
    painter.drawPolygon(bandOf(k));
    painter.setPen(QPen(colourOf(k), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    const QString name = painter.fontMetrics().elidedText(
        QString::fromStdString(plot.series[k].name), Qt::ElideMiddle, int(4 * text));
    write({line.back() + QPointF(10, -text), QSizeF(4.2 * text, 2 * text)}, Qt::AlignLeft,
          name.toStdString(), colourOf(k));
  }

  /// Returns the intervals' lower ends from left to right, then the upper ones back.
  [[nodiscard]] QPolygonF bandOf(std::size_t k) const {
    QPolygonF low, high;
    for (const Plot::Point& point : plot.series[k].points) {
      const double x = area.across.at(point.across);
      low << QPointF(x, area.up.at(point.interval.low));
      high.prepend({x, area.up.at(point.interval.high)});
    }
    return low + high;
  }

  void paintPoints(std::optional<std::size_t> selected) const {
    const Plot::Point* chosen = nullptr;
    std::size_t chosenSeries = 0;
    for (std::size_t k = 0; k < plot.series.size(); ++k)
      for (const Plot::Point& point : plot.series[k].points) {
        painter.setPen(QPen(colours.background, 1));
        painter.setBrush(plot.shades ? shadeOf(point.shade) : colourOf(k));
        paintMark(painter, pointAt(area, point, k), plot.series[k].radius, k);
        if (point.row != selected) continue;
        chosen = &point;
        chosenSeries = k;
      }
    if (chosen == nullptr) return;
    const QPointF at = pointAt(area, *chosen, chosenSeries);
    const double radius = plot.series[chosenSeries].radius + 4;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.accent, 2));
    painter.drawEllipse(at, radius, radius);
    const bool isRight = at.x() < (area.across.from + area.across.to) / 2;
    const double gap = radius + 6;
    const QRectF box(isRight ? at.x() + gap : at.x() - gap - 400, at.y() - text, 400, 2 * text);
    write(box, isRight ? Qt::AlignLeft : Qt::AlignRight, chosen->name, colours.accent);
  }

  void paintLegend() const {
    const double line = 1.5 * text;
    double x = area.across.from;
    const double each = (size.width() - x) / double(plot.series.size());
    for (std::size_t k = 0; k < plot.series.size(); ++k, x += each) {
      const double y = size.height() - 0.6 * line;
      painter.setPen(Qt::NoPen);
      painter.setBrush(colourOf(k));
      paintMark(painter, {x + 5, y}, 4, k);
      const QString name = painter.fontMetrics().elidedText(
          QString::fromStdString(plot.series[k].name), Qt::ElideMiddle, int(each - 20));
      write({x + 14, y - text, each - 14, 2 * text}, Qt::AlignLeft, name.toStdString(),
            colours.text2);
    }
  }
};

}  // namespace

void paintMark(QPainter& painter, const QPointF& at, double radius, std::size_t series) {
  const std::vector<double> corners = markCorners(series);
  if (corners.empty()) return painter.drawEllipse(at, radius, radius);
  QPolygonF polygon;
  for (std::size_t k = 0; k < corners.size(); k += 2)
    polygon << at + radius * QPointF(corners[k], corners[k + 1]);
  painter.drawPolygon(polygon);
}

void paintColourBar(QPainter& painter, const QRectF& bar, const QString& low, const QString& high,
                    const QColor& text) {
  QLinearGradient colours(bar.bottomLeft(), bar.topLeft());
  constexpr int steps = 16;
  for (int k = 0; k <= steps; ++k)
    colours.setColorAt(double(k) / steps, shadeColour(double(k) / steps));
  painter.fillRect(bar, colours);
  painter.setPen(text);
  const QRectF beside(bar.right() + 5, bar.top(), 100, bar.height());
  painter.drawText(beside, Qt::AlignLeft | Qt::AlignTop, high);
  painter.drawText(beside, Qt::AlignLeft | Qt::AlignBottom, low);
}

void paintPlot(QPainter& painter, const QSizeF& size, const Plot& plot, const ChartColours& colours,
               std::optional<std::size_t> selected) {
  painter.save();
  const PlotPainter parts{painter, size, plot, colours};
  parts.paintFrame();
  parts.paintLines();
  for (std::size_t k = 0; plot.hasCurves && k < plot.series.size(); ++k) parts.paintCurve(k);
  parts.paintPoints(selected);
  if (hasLegend(plot)) parts.paintLegend();
  if (plot.shades) {
    const QRectF bar(parts.area.across.to + 14, parts.area.up.to + 1.5 * parts.text, 8,
                     parts.area.up.from - parts.area.up.to - 1.5 * parts.text);
    paintColourBar(painter, bar, QString::fromStdString(rounded(plot.shades->low, 1)),
                   QString::fromStdString(rounded(plot.shades->high, 1)), colours.text2);
    parts.write({bar.left() - 6, parts.area.up.to - 0.4 * parts.text, 80, 1.5 * parts.text},
                Qt::AlignLeft, "dB", colours.text2);
  }
  painter.restore();
}

std::optional<std::size_t> rowAt(const Plot& plot, const QPointF& place, const QSizeF& size,
                                 double text) {
  constexpr double farthest = 8;  // pixels
  const PlotArea area = areaOf(plot, size, text);
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

std::optional<QPointF> placeOf(const Plot& plot, std::size_t row, const QSizeF& size, double text) {
  const PlotArea area = areaOf(plot, size, text);
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const Plot::Point& point : plot.series[k].points)
      if (point.row == row) return pointAt(area, point, k);
  return std::nullopt;
}

}  // namespace hogelscope
