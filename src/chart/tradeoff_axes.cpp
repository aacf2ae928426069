// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_axes.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "chart/recommendations.h"

namespace hogelscope {

namespace {

const QColor ink(40, 40, 40);
const QColor faint(225, 225, 225);
const QColor smoothArea(238, 244, 250);  // within the time of 60 views per second
const QString zeroText = QStringLiteral("0: the reference’s own pixels");

struct Guide {
  double milliseconds;
  const char* caption;
  Qt::AlignmentFlag side;  // of the line, for the caption
};
constexpr std::array guidesOfViews{Guide{movingViewMilliseconds, "60 views/s", Qt::AlignRight},
                                   Guide{1000.0 / 30, "30 views/s", Qt::AlignLeft}};

/// A range of base-10 logarithms.
struct LogRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;

  void add(double value) {
    least = std::min(least, std::log10(value));
    most = std::max(most, std::log10(value));
  }
  /// Returns an axis of at least a decade, so that it has ticks, with margins that keep markers off
  /// the frame.
  Axis axis(double from, double to) const {
    constexpr double margin = 0.06;
    if (least > most) return {0, 2, from, to};
    const double decades = std::max(1 - 2 * margin, most - least);
    const double middle = (least + most) / 2;
    const double half = (0.5 + margin) * decades;
    return {std::max(middle - half, -307.0), std::min(middle + half, 308.0), from, to};
  }
};

void text(QPainter& painter, const QRectF& box, int flags, const QString& words) {
  painter.drawText(box, flags | Qt::TextSingleLine | Qt::TextDontClip, words);
}

/// Paints a text upwards, centred on a point.
void sideways(QPainter& painter, const QPointF& centre, const QString& words) {
  painter.save();
  painter.translate(centre);
  painter.rotate(-90);
  text(painter, {-200, -10, 400, 20}, Qt::AlignCenter, words);
  painter.restore();
}

}  // namespace

QFont sized(QFont font, double size, bool isBold) {
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(size))));
  font.setBold(isBold);
  return font;
}

TradeoffAxes::TradeoffAxes(const std::vector<TradeoffRow>& rows, const QSizeF& size)
    : m_size(size), m_em(std::clamp(size.width() / 44, 11.0, 16.0)) {
  LogRange times;
  LogRange errors;
  bool hasZeros = false;
  for (const TradeoffRow& row : rows) {
    if (!isMeasured(row)) continue;
    for (const double time : {row.lowerQuartile, row.milliseconds, row.upperQuartile})
      times.add(time);
    if (row.rmse > 0) errors.add(row.rmse);
    hasZeros = hasZeros || row.rmse == 0;
  }
  // Includes the limit of smooth motion if times come near it.
  if (times.most > std::log10(movingViewMilliseconds / 10)) times.add(movingViewMilliseconds);

  m_plot = QRectF({0, 0}, size).adjusted(5.2 * m_em, 4.7 * m_em, -4 * m_em, -3.6 * m_em);
  m_plot.setSize(m_plot.size().expandedTo({1, 1}));  // for very small charts
  if (hasZeros) {
    const double gap = std::min(0.5 * m_em, 0.1 * m_plot.height());
    const double height = std::min(5.5 * m_em, 0.5 * m_plot.height());
    m_zero = m_plot.adjusted(0, m_plot.height() - height, 0, 0);
    m_plot.setBottom(m_zero.top() - gap);
  }
  m_times = times.axis(m_plot.left(), m_plot.right());
  m_errors = errors.axis(m_plot.bottom(), m_plot.top());
}

double TradeoffAxes::x(double milliseconds) const {
  return m_times.at(std::log10(milliseconds));
}

double TradeoffAxes::y(double rmse) const {
  return m_errors.at(std::log10(rmse));
}

std::optional<QPointF> TradeoffAxes::positionOf(const TradeoffRow& row) const {
  if (!isMeasured(row)) return std::nullopt;
  return QPointF(x(row.milliseconds), row.rmse > 0 ? y(row.rmse) : m_zero.center().y());
}

QLineF TradeoffAxes::quartilesOf(const TradeoffRow& row) const {
  const double y = positionOf(row)->y();
  return {x(row.lowerQuartile), y, x(row.upperQuartile), y};
}

std::vector<QRectF> TradeoffAxes::areas() const {
  if (m_zero.isEmpty()) return {m_plot};
  return {m_plot, m_zero};
}

std::vector<QLineF> TradeoffAxes::guides() const {
  std::vector<QLineF> lines;
  const double bottom = areas().back().bottom();
  for (const Guide& guide : guidesOfViews) {
    const double at = x(guide.milliseconds);
    if (at >= m_plot.left() && at <= m_plot.right())
      lines.emplace_back(at, m_plot.top(), at, bottom);
  }
  return lines;
}

QRectF TradeoffAxes::zeroCaption(const QFont& font) const {
  if (m_zero.isEmpty()) return {};
  const QFontMetricsF metrics(sized(font, 0.9 * m_em));
  const double width = metrics.horizontalAdvance(zeroText);
  // Avoids the Pareto front, which comes from above and ends at half height.
  return {m_zero.right() - 0.5 * m_em - width, m_zero.bottom() - 0.2 * m_em - metrics.height(),
          width, metrics.height()};
}

void TradeoffAxes::paint(QPainter& painter, const QString& title) const {
  painter.save();
  const QFont font = painter.font();
  for (const QRectF& area : areas()) paintGround(painter, area);
  painter.setFont(sized(font, 0.9 * m_em));
  paintTimes(painter);
  paintErrors(painter);
  paintPsnr(painter);
  paintGuides(painter);
  paintZero(painter);
  paintFrames(painter);
  painter.setFont(font);
  paintTitles(painter, title);
  painter.restore();
}

void TradeoffAxes::paintGround(QPainter& painter, const QRectF& box) const {
  QRectF smooth = box;
  QRectF slow = box;
  smooth.setRight(std::clamp(x(movingViewMilliseconds), box.left(), box.right()));
  slow.setLeft(smooth.right());
  painter.fillRect(smooth, smoothArea);
  painter.fillRect(slow, Qt::white);
}

void TradeoffAxes::paintFrames(QPainter& painter) const {
  painter.setPen(QPen(ink, 1));
  painter.setBrush(Qt::NoBrush);
  for (const QRectF& area : areas()) painter.drawRect(area);
}

void TradeoffAxes::paintGuides(QPainter& painter) const {
  painter.setPen(QPen(ink, 1, Qt::DashLine));
  for (const QLineF& line : guides()) painter.drawLine(line);
  for (const Guide& guide : guidesOfViews) {
    const double at = x(guide.milliseconds);
    if (at < m_plot.left() || at > m_plot.right()) continue;
    QRectF box(0, m_plot.top() - 1.4 * m_em, 8 * m_em, 1.2 * m_em);
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(guide.caption);
    if (guide.side == Qt::AlignRight)
      box.moveRight(at + 0.1 * m_em);
    else
      box.moveLeft(std::min(at, m_size.width() - width) - 0.1 * m_em);
    text(painter, box, guide.side | Qt::AlignVCenter, guide.caption);
  }
}

void TradeoffAxes::paintTimes(QPainter& painter) const {
  const double bottom = areas().back().bottom();
  for (const Tick& tick : logarithmicTicks(m_times, 3.2 * m_em)) {
    const double at = x(tick.value);
    const bool isMinor = tick.text.empty();
    painter.setPen(QPen(faint, 1));
    for (const QRectF& area : areas())
      if (!isMinor) painter.drawLine(QLineF(at, area.top(), at, area.bottom()));
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QLineF(at, bottom, at, bottom + (isMinor ? 3 : 6)));
    text(painter, {at - 50, bottom + 7, 100, 1.2 * m_em}, Qt::AlignHCenter | Qt::AlignTop,
         QString::fromStdString(tick.text));
  }
}

void TradeoffAxes::paintErrors(QPainter& painter) const {
  for (const Tick& tick : logarithmicTicks(m_errors, 2.2 * m_em)) {
    const double at = y(tick.value);
    const bool isMinor = tick.text.empty();
    painter.setPen(QPen(faint, 1));
    if (!isMinor) painter.drawLine(QLineF(m_plot.left(), at, m_plot.right(), at));
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QLineF(m_plot.left() - (isMinor ? 3 : 6), at, m_plot.left(), at));
    text(painter, {m_plot.left() - 108, at - 10, 100, 20}, Qt::AlignRight | Qt::AlignVCenter,
         QString::fromStdString(tick.text));
  }
}

/// Paints the error axis in dB: PSNR = 20 log10(255 / RMS error).
void TradeoffAxes::paintPsnr(QPainter& painter) const {
  const double logCodeValues = std::log10(255.0);
  const Axis decibels{20 * (logCodeValues - m_errors.high), 20 * (logCodeValues - m_errors.low),
                      m_plot.top(), m_plot.bottom()};
  painter.setPen(QPen(ink, 1));
  const int most = std::max(1, static_cast<int>(m_plot.height() / (2.5 * m_em)));
  for (const Tick& tick : linearTicks(decibels, most)) {
    const double at = decibels.at(tick.value);
    painter.drawLine(QLineF(m_plot.right(), at, m_plot.right() + 6, at));
    text(painter, {m_plot.right() + 8, at - 10, 100, 20}, Qt::AlignLeft | Qt::AlignVCenter,
         QString::fromStdString(tick.text));
  }
}

void TradeoffAxes::paintZero(QPainter& painter) const {
  if (m_zero.isEmpty()) return;
  const double y = m_zero.center().y();
  painter.setPen(QPen(faint, 1));
  painter.drawLine(QLineF(m_zero.left(), y, m_zero.right(), y));
  painter.setPen(QPen(ink, 1));
  text(painter, {m_zero.left() - 108, y - 10, 100, 20}, Qt::AlignRight | Qt::AlignVCenter, "0");
  text(painter, {m_zero.right() + 8, y - 10, 100, 20}, Qt::AlignLeft | Qt::AlignVCenter, "∞");
  const QRectF caption = zeroCaption(painter.font());
  paintGround(painter, caption);
  text(painter, caption, Qt::AlignLeft | Qt::AlignVCenter, zeroText);
}

void TradeoffAxes::paintTitles(QPainter& painter, const QString& title) const {
  const QFont font = painter.font();
  painter.setPen(ink);
  painter.setFont(sized(font, 1.25 * m_em, true));
  const double width = m_size.width() - 2 * m_em;
  text(painter, {m_em, 0.5 * m_em, width, 1.6 * m_em}, Qt::AlignLeft | Qt::AlignVCenter,
       painter.fontMetrics().elidedText(title, Qt::ElideRight, static_cast<int>(width)));
  painter.setFont(sized(font, m_em));
  text(painter, {m_plot.left(), m_size.height() - 1.7 * m_em, m_plot.width(), 1.4 * m_em},
       Qt::AlignCenter, QStringLiteral("milliseconds per picture"));
  sideways(painter, {1.1 * m_em, m_plot.center().y()}, QStringLiteral("RMS error, code values"));
  sideways(painter, {m_size.width() - 1.0 * m_em, m_plot.center().y()}, QStringLiteral("PSNR, dB"));
}

}  // namespace hogelscope
