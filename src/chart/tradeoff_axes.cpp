// SPDX-License-Identifier: BSD-3-Clause
// Axes of the chart of speed against accuracy.
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
const QColor smoothArea(238, 244, 250);  // within 60 views per second
const QString zeroText = QStringLiteral("0: the reference’s own pixels");

struct Guide {
  double milliseconds;
  const char* caption;
  Qt::AlignmentFlag side;  // of the line, where the caption stands
};
constexpr std::array guidesOfViews{Guide{movingViewMilliseconds, "60 views/s", Qt::AlignRight},
                                   Guide{1000.0 / 30, "30 views/s", Qt::AlignLeft}};

struct Range {
  double least = 0;
  double most = 0;  ///< 0: nothing yet

  void take(double value) {
    least = most > 0 ? std::min(least, value) : value;
    most = std::max(most, value);
  }
  /// Room beyond both ends, as shares of the range: no marker lies on the frame.
  Range widened(double before, double behind) const {
    using Limits = std::numeric_limits<double>;
    const double decades = std::max(1.0, std::log10(most) - std::log10(least));
    return {std::max(least / std::pow(10.0, before * decades), Limits::min()),
            std::min(most * std::pow(10.0, behind * decades), Limits::max())};
  }
};

void text(QPainter& painter, const QRectF& box, int flags, const QString& words) {
  painter.drawText(box, flags | Qt::TextSingleLine | Qt::TextDontClip, words);
}

/// Upwards, around a point.
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
    : m_size(size), m_em(std::clamp(size.width() / 64, 11.0, 16.0)) {
  Range times;
  Range errors;
  int zeros = 0;
  for (const TradeoffRow& row : rows) {
    if (!isMeasured(row)) continue;
    times.take(row.milliseconds);
    if (row.rmse > 0) errors.take(row.rmse);
    zeros += row.rmse == 0 ? 1 : 0;
  }
  if (times.most == 0) times = {1, 100};
  if (errors.most == 0) errors = {0.1, 10};
  // Whether a view moves smoothly is seen where its limit is seen.
  if (times.most > movingViewMilliseconds / 10) times.take(movingViewMilliseconds);

  m_plot = QRectF({0, 0}, size).adjusted(5.2 * m_em, 4.7 * m_em, -4 * m_em, -3.6 * m_em);
  m_plot.setSize(m_plot.size().expandedTo({1, 1}));  // however small the chart
  if (zeros > 0) {
    const double gap = std::min(0.5 * m_em, 0.1 * m_plot.height());
    const double height = std::min((4.5 + 0.6 * zeros) * m_em, 0.5 * m_plot.height());
    m_zero = m_plot.adjusted(0, m_plot.height() - height, 0, 0);
    m_plot.setBottom(m_zero.top() - gap);
  }
  times = times.widened(0.05, 0.05);
  errors = errors.widened(0.06, 0.11);  // the fastest want their names above them
  m_times = LogAxis(times.least, times.most, m_plot.left(), m_plot.right());
  m_errors = LogAxis(errors.least, errors.most, m_plot.bottom(), m_plot.top());
}

std::optional<QPointF> TradeoffAxes::place(const TradeoffRow& row) const {
  if (!isMeasured(row)) return std::nullopt;
  const double y = row.rmse > 0 ? m_errors.place(row.rmse) : m_zero.center().y();
  return QPointF(m_times.place(row.milliseconds), y);
}

std::vector<QRectF> TradeoffAxes::areas() const {
  if (m_zero.isEmpty()) return {m_plot};
  return {m_plot, m_zero};
}

std::vector<QLineF> TradeoffAxes::guides() const {
  std::vector<QLineF> lines;
  const double bottom = areas().back().bottom();
  for (const Guide& guide : guidesOfViews) {
    const double x = m_times.place(guide.milliseconds);
    if (m_times.holds(guide.milliseconds)) lines.emplace_back(x, m_plot.top(), x, bottom);
  }
  return lines;
}

QRectF TradeoffAxes::zeroCaption(const QFont& font) const {
  if (m_zero.isEmpty()) return {};
  const QFontMetricsF metrics(sized(font, 0.9 * m_em));
  const double width = metrics.horizontalAdvance(zeroText);
  // On the right, where it is slow: nobody's choice lies there.
  return {m_zero.right() - 0.5 * m_em - width, m_zero.top() + 0.2 * m_em, width, metrics.height()};
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
  const double limit = m_times.place(movingViewMilliseconds);
  QRectF smooth = box;
  QRectF slow = box;
  smooth.setRight(std::clamp(limit, box.left(), box.right()));
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
    if (!m_times.holds(guide.milliseconds)) continue;
    QRectF box(0, m_plot.top() - 1.4 * m_em, 8 * m_em, 1.2 * m_em);
    const double x = m_times.place(guide.milliseconds);
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(guide.caption);
    if (guide.side == Qt::AlignRight)
      box.moveRight(x + 0.1 * m_em);
    else
      box.moveLeft(std::min(x, m_size.width() - width) - 0.1 * m_em);
    text(painter, box, guide.side | Qt::AlignVCenter, guide.caption);
  }
}

void TradeoffAxes::paintTimes(QPainter& painter) const {
  const double bottom = areas().back().bottom();
  for (const Tick& tick : m_times.ticks(3.2 * m_em)) {
    const double x = tick.place;
    painter.setPen(QPen(faint, 1));
    if (tick.isLabelled)
      for (const QRectF& area : areas()) painter.drawLine(QLineF(x, area.top(), x, area.bottom()));
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QLineF(x, bottom, x, bottom + (tick.isLabelled ? 6 : 3)));
    if (tick.isLabelled)
      text(painter, {x - 50, bottom + 7, 100, 1.2 * m_em}, Qt::AlignHCenter | Qt::AlignTop,
           QString::number(tick.value, 'g', 4));
  }
}

void TradeoffAxes::paintErrors(QPainter& painter) const {
  for (const Tick& tick : m_errors.ticks(2.2 * m_em)) {
    const double y = tick.place;
    painter.setPen(QPen(faint, 1));
    if (tick.isLabelled) painter.drawLine(QLineF(m_plot.left(), y, m_plot.right(), y));
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QLineF(m_plot.left() - (tick.isLabelled ? 6 : 3), y, m_plot.left(), y));
    if (tick.isLabelled)
      text(painter, {m_plot.left() - 108, y - 10, 100, 20}, Qt::AlignRight | Qt::AlignVCenter,
           QString::number(tick.value, 'g', 4));
  }
}

/// PSNR = 20 log10(255 / RMS error): the same axis, read in dB.
void TradeoffAxes::paintPsnr(QPainter& painter) const {
  const double logCodeValues = std::log10(255.0);
  const double least = 20 * (logCodeValues - m_errors.mostLog());
  const double most = 20 * (logCodeValues - m_errors.leastLog());
  int step = 5;
  while (step * m_plot.height() / (most - least) < 2.5 * m_em && step < most - least) step *= 2;
  painter.setPen(QPen(ink, 1));
  for (int k = static_cast<int>(std::ceil(least / step)); k * step <= most; ++k) {
    const double y = m_errors.place(std::pow(10.0, logCodeValues - k * step / 20.0));
    painter.drawLine(QLineF(m_plot.right(), y, m_plot.right() + 6, y));
    text(painter, {m_plot.right() + 8, y - 10, 100, 20}, Qt::AlignLeft | Qt::AlignVCenter,
         QString::number(k * step));
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
