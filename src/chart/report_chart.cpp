// SPDX-License-Identifier: BSD-3-Clause
// The PSNR of a report's rows over their states or viewing angles.
#include "chart/report_chart.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/colour_map.h"

namespace hogelscope {

namespace {

constexpr double radius = 4;

/// Out to where the points are, and a little further.
void pad(Axis& axis, double least) {
  if (!(axis.low <= axis.high)) axis.low = axis.high = 0;
  const double range = axis.high - axis.low;
  const double by = std::max(0.05 * range, least - range / 2);
  axis.low -= by;
  axis.high += by;
}

}  // namespace

/// Where things lie on a chart of one size.
struct ReportChart::Area {
  QRectF frame;  ///< of the finite PSNRs
  QRectF strip;  ///< of the identical views, above
  Axis across{HUGE_VAL, -HUGE_VAL, 0, 1};
  Axis up{HUGE_VAL, -HUGE_VAL, 1, 0};

  [[nodiscard]] QPointF at(const Point& point) const {
    const double x = across.at(point.across);
    return {x, std::isinf(point.psnr) ? strip.center().y() : up.at(point.psnr)};
  }
};

ReportChart::ReportChart(std::vector<Point> points, QString titleAcross,
                         std::vector<QString> series)
    : m_points(std::move(points)),
      m_titleAcross(std::move(titleAcross)),
      m_series(std::move(series)) {
  std::erase_if(m_points, [](const Point& point) { return std::isnan(point.psnr); });
}

ReportChart::Area ReportChart::areaOf(const QSizeF& size) const {
  constexpr double left = 52, right = 12, top = 8, bottom = 40, line = 18;
  Area area;
  bool hasIdentical = false;
  for (const Point& point : m_points) {
    area.across.low = std::min(area.across.low, point.across);
    area.across.high = std::max(area.across.high, point.across);
    if (std::isinf(point.psnr)) {
      hasIdentical = true;
    } else {
      area.up.low = std::min(area.up.low, point.psnr);
      area.up.high = std::max(area.up.high, point.psnr);
    }
  }
  pad(area.across, 0.5);
  pad(area.up, 1);
  const double legend = m_series.size() > 1 ? line * double(m_series.size()) : 0;
  const double height = std::max(20.0, size.height() - top - bottom - legend);
  const double strip = hasIdentical ? std::min(22.0, height / 4) : 0;
  const double width = std::max(20.0, size.width() - left - right);
  area.strip = QRectF(left, top, width, strip);
  area.frame = QRectF(left, top + strip, width, height - strip);
  area.across.from = area.frame.left();
  area.across.to = area.frame.right();
  area.up.from = area.frame.bottom();
  area.up.to = area.frame.top();
  return area;
}

void ReportChart::paint(QPainter& painter, const QSizeF& size) const {
  const Area area = areaOf(size);
  painter.save();
  QFont font = painter.font();
  font.setPixelSize(12);
  painter.setFont(font);
  paintFrame(painter, area);
  paintPoints(painter, area);
  if (m_series.size() > 1) paintLegend(painter, area);
  painter.restore();
}

void ReportChart::paintFrame(QPainter& painter, const Area& area) const {
  const QColor grid(221, 221, 221);
  const QRectF& frame = area.frame;
  for (const Tick& tick : linearTicks(area.across, std::max(2, int(frame.width() / 60)))) {
    const double x = area.across.at(tick.value);
    painter.setPen(grid);
    painter.drawLine(QPointF(x, area.strip.top()), QPointF(x, frame.bottom()));
    painter.setPen(Qt::black);
    painter.drawText(QRectF(x - 40, frame.bottom() + 3, 80, 16), Qt::AlignCenter,
                     QString::fromStdString(tick.text));
  }
  for (const Tick& tick : linearTicks(area.up, std::max(2, int(frame.height() / 28)))) {
    const double y = area.up.at(tick.value);
    painter.setPen(grid);
    painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
    painter.setPen(Qt::black);
    painter.drawText(QRectF(18, y - 8, frame.left() - 23, 16), Qt::AlignRight | Qt::AlignVCenter,
                     QString::fromStdString(tick.text));
  }
  painter.setPen(QColor(136, 136, 136));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame);
  if (area.strip.height() > 0) painter.drawRect(area.strip);
  painter.setPen(Qt::black);
  if (area.strip.height() > 0)
    painter.drawText(area.strip.adjusted(6, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     QObject::tr("identical"));
  painter.drawText(QRectF(frame.left(), frame.bottom() + 20, frame.width(), 16), Qt::AlignCenter,
                   m_titleAcross);
  painter.save();
  painter.translate(10, frame.center().y());
  painter.rotate(-90);
  painter.drawText(QRectF(-100, -8, 200, 16), Qt::AlignCenter, QObject::tr("PSNR seen, dB"));
  painter.restore();
}

void ReportChart::paintPoints(QPainter& painter, const Area& area) const {
  painter.setPen(QPen(Qt::white, 0.8));
  for (const Point& point : m_points) {
    painter.setBrush(QColor(seriesColour(point.series)));
    painter.drawEllipse(area.at(point), radius, radius);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 2));
  for (const Point& point : m_points)
    if (point.row == m_selected) painter.drawEllipse(area.at(point), radius + 3, radius + 3);
}

void ReportChart::paintLegend(QPainter& painter, const Area& area) const {
  double y = area.frame.bottom() + 50;
  for (std::size_t k = 0; k < m_series.size(); ++k, y += 18) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(seriesColour(k)));
    painter.drawEllipse(QPointF(area.frame.left() + 6, y), radius, radius);
    painter.setPen(Qt::black);
    const QRectF text(area.frame.left() + 18, y - 8, area.frame.width() - 18, 16);
    painter.drawText(
        text, Qt::AlignLeft | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(m_series[k], Qt::ElideMiddle, int(text.width())));
  }
}

std::optional<std::size_t> ReportChart::rowAt(const QPointF& place, const QSizeF& size) const {
  constexpr double farthest = 8;  // points
  const Area area = areaOf(size);
  std::optional<std::size_t> row;
  double least = farthest;
  for (const Point& point : m_points) {
    const QPointF way = area.at(point) - place;
    if (const double distance = std::hypot(way.x(), way.y()); distance <= least) {
      least = distance;
      row = point.row;
    }
  }
  return row;
}

std::optional<QPointF> ReportChart::placeOf(std::size_t row, const QSizeF& size) const {
  const auto found = std::ranges::find(m_points, row, &Point::row);
  if (found == m_points.end()) return std::nullopt;
  return areaOf(size).at(*found);
}

}  // namespace hogelscope
