// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_axes.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "chart/recommendations.h"

namespace hogelscope {

namespace {

struct Guide {
  double milliseconds;
  const char* caption;
};
constexpr std::array guidesOfViews{Guide{movingViewMilliseconds, "60 views/s"},
                                   Guide{1000.0 / 30, "30 views/s"}};

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

QColor faded(QColor colour, double alpha) {
  colour.setAlphaF(float(alpha));
  return colour;
}

}  // namespace

void paintText(QPainter& painter, const QRectF& box, int flags, const QString& words) {
  painter.drawText(box, flags | Qt::TextSingleLine | Qt::TextDontClip, words);
}

QString figureText(double value) {
  const bool isLong = value >= 99.5 && value < 1e6;
  return isLong ? QString::number(value, 'f', 0) : QString::number(value, 'g', 2);
}

QString timeText(double milliseconds) {
  return milliseconds < 999.5 ? figureText(milliseconds) + " ms"
                              : figureText(milliseconds / 1000) + " s";
}

TradeoffAxes::TradeoffAxes(const std::vector<TradeoffRow>& rows, const QRectF& area,
                           const QFont& font)
    : m_area(area), m_font(font), m_em(QFontInfo(font).pixelSize()) {
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
  // Includes the limit of smooth motion if times come near it, with room for its caption.
  if (times.most > std::log10(movingViewMilliseconds / 10)) times.add(movingViewMilliseconds / 2);

  const double below = hasTimeTitle() ? 3.3 : 1.8;
  m_plot = area.adjusted(4 * m_em, 2.2 * m_em, -3.6 * m_em, -below * m_em);
  m_plot.setSize(m_plot.size().expandedTo({1, 1}));  // for very small charts
  if (hasZeros) {
    const double gap = std::min(m_em, 0.1 * m_plot.height());
    const double height = std::min(2.8 * m_em, 0.3 * m_plot.height());
    m_zero = m_plot.adjusted(0, m_plot.height() - height, 0, 0);
    m_plot.setBottom(m_zero.top() - gap);
  }
  const double captions = std::min(1.8 * m_em, 0.3 * m_plot.height());
  m_times = times.axis(m_plot.left(), m_plot.right());
  m_errors = errors.axis(m_plot.bottom(), m_plot.top() + captions);
  placeGuideCaptions();
  placeZeroCaption(rows);
}

/// Places the caption of 60 views per second left of its line, and that of 30 right of its line,
/// where they fit.
void TradeoffAxes::placeGuideCaptions() {
  const QFontMetricsF metrics(m_font);
  for (const Guide& guide : guidesOfViews) {
    const double at = x(guide.milliseconds);
    if (at < m_plot.left() || at > m_plot.right()) continue;
    QRectF box(at + 0.5 * m_em, m_plot.top() + 0.3 * m_em, metrics.horizontalAdvance(guide.caption),
               metrics.height());
    const double left = at - 0.5 * m_em - box.width();
    if (guide.milliseconds == movingViewMilliseconds && left > m_plot.left()) box.moveLeft(left);
    const auto isCrossed = [&](const Guide& other) {
      return x(other.milliseconds) > box.left() && x(other.milliseconds) < box.right();
    };
    if (m_plot.contains(box) && std::ranges::none_of(guidesOfViews, isCrossed))
      m_captions.push_back({box, guide.caption});
  }
}

/// Places the band's caption at its right or left end, where no point is.
void TradeoffAxes::placeZeroCaption(const std::vector<TradeoffRow>& rows) {
  const QString words = QStringLiteral("the reference’s own pixels");
  const QFontMetricsF metrics(m_font);
  QRectF box({0, 0}, QSizeF(metrics.horizontalAdvance(words), metrics.height()));
  box.moveCenter(m_zero.center());
  for (const double left : {m_zero.right() - m_em - box.width(), m_zero.left() + m_em}) {
    box.moveLeft(left);
    const auto isCovered = [&](const TradeoffRow& row) {
      return isMeasured(row) && box.adjusted(-m_em, 0, m_em, 0).contains(*positionOf(row));
    };
    if (m_zero.contains(box) && std::ranges::none_of(rows, isCovered))
      return m_captions.push_back({box, words});
  }
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

QLineF TradeoffAxes::errorBarOf(const TradeoffRow& row) const {
  if (!(row.psnrLow < row.psnrHigh)) return {};
  const auto at = [this](double rmse) {
    return rmse > 0 ? std::clamp(y(rmse), m_plot.top(), m_plot.bottom()) : m_plot.bottom();
  };
  const double x = positionOf(row)->x();
  const auto [least, most] = errorRangeOf(row);
  return {x, at(most), x, row.rmse > 0 ? at(least) : positionOf(row)->y()};
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

std::vector<QRectF> TradeoffAxes::captionBoxes() const {
  std::vector<QRectF> boxes;
  for (const auto& [box, words] : m_captions) boxes.push_back(box);
  return boxes;
}

void TradeoffAxes::paint(QPainter& painter, const ChartColours& colours, const QString& title,
                         const std::vector<QRectF>& gaps) const {
  painter.save();
  painter.setFont(m_font);
  for (const QRectF& area : areas()) paintGround(painter, colours, area);
  paintTimes(painter, colours);
  paintErrors(painter, colours);
  painter.setPen(QPen(colours.text2, 1, Qt::DashLine));
  for (const QLineF& line : guides()) painter.drawLine(line);
  for (const auto& boxes : {captionBoxes(), gaps})
    for (const QRectF& box : boxes) paintGround(painter, colours, box);
  painter.setPen(colours.text2);
  for (const auto& [box, words] : m_captions)
    paintText(painter, box, Qt::AlignLeft | Qt::AlignVCenter, words);
  painter.setPen(QPen(colours.line, 1));
  painter.setBrush(Qt::NoBrush);
  for (const QRectF& area : areas()) painter.drawRect(area);
  paintTitles(painter, colours, title);
  painter.restore();
}

/// Tints the times within 60 views per second, and less so those within 30.
void TradeoffAxes::paintGround(QPainter& painter, const ChartColours& colours,
                               const QRectF& box) const {
  painter.fillRect(box, colours.background);
  for (const Guide& guide : guidesOfViews) {
    QRectF smooth = box;
    smooth.setRight(std::clamp(x(guide.milliseconds), box.left(), box.right()));
    painter.fillRect(smooth, faded(colours.series[0], 0.06));
  }
}

void TradeoffAxes::paintTimes(QPainter& painter, const ChartColours& colours) const {
  const double bottom = areas().back().bottom();
  for (const Tick& tick : logarithmicTicks(m_times, 4.5 * m_em)) {
    const double at = x(tick.value);
    const bool isMinor = tick.text.empty();
    painter.setPen(QPen(colours.grid, 1));
    for (const QRectF& area : areas())
      if (!isMinor) painter.drawLine(QLineF(at, area.top(), at, area.bottom()));
    painter.setPen(QPen(colours.text2, 1));
    painter.drawLine(QLineF(at, bottom, at, bottom + (isMinor ? 2 : 4)));
    if (!isMinor)
      paintText(painter, {at - 50, bottom + 6, 100, 1.2 * m_em}, Qt::AlignHCenter | Qt::AlignTop,
                timeText(tick.value));
  }
}

/// Paints the errors on the left, and on the right in dB: PSNR = 20 log10(255 / RMS error).
void TradeoffAxes::paintErrors(QPainter& painter, const ChartColours& colours) const {
  const auto paintTick = [&](double from, double to, double at, const QString& words) {
    painter.setPen(QPen(colours.text2, 1));
    painter.drawLine(QLineF(from, at, to, at));
    const bool isLeft = to < from;
    paintText(painter, {isLeft ? to - 104 : to + 4, at - 10, 100, 20},
              (isLeft ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter, words);
  };
  const double left = m_plot.left();
  const double right = m_plot.right();
  for (const Tick& tick : logarithmicTicks(m_errors, 2.2 * m_em)) {
    const double at = y(tick.value);
    const bool isMinor = tick.text.empty();
    painter.setPen(QPen(colours.grid, 1));
    if (!isMinor) painter.drawLine(QLineF(left, at, right, at));
    paintTick(left, left - (isMinor ? 2 : 4), at, QString::fromStdString(tick.text));
  }
  const double logCodeValues = std::log10(255.0);
  const Axis decibels{20 * (logCodeValues - m_errors.high), 20 * (logCodeValues - m_errors.low),
                      m_errors.to, m_errors.from};
  const int most = std::max(1, static_cast<int>(m_plot.height() / (2.5 * m_em)));
  for (const Tick& tick : linearTicks(decibels, most))
    paintTick(right, right + 4, decibels.at(tick.value), QString::fromStdString(tick.text));
  if (m_zero.isEmpty()) return;
  paintTick(left, left - 4, m_zero.center().y(), "0");
  paintTick(right, right + 4, m_zero.center().y(), "∞");
}

void TradeoffAxes::paintTitles(QPainter& painter, const ChartColours& colours,
                               const QString& title) const {
  QFont strong = m_font;
  strong.setWeight(QFont::Medium);
  const QFontMetricsF metrics(strong);
  const QString psnr = QStringLiteral("PSNR, dB");
  const QString hint = QStringLiteral(" · lower is better");
  QRectF row(m_area.left() + m_em, m_area.top(), m_area.width() - 2 * m_em, 2 * m_em);
  painter.setFont(strong);
  painter.setPen(colours.text);
  const double room = row.width() - metrics.horizontalAdvance(psnr) - m_em;
  const double width = metrics.horizontalAdvance(title);
  paintText(painter, row, Qt::AlignLeft | Qt::AlignVCenter,
            metrics.elidedText(title, Qt::ElideRight, room));
  paintText(painter, row, Qt::AlignRight | Qt::AlignVCenter, psnr);
  painter.setFont(m_font);
  if (width + metrics.horizontalAdvance(hint) < room) {
    painter.setPen(colours.text2);
    paintText(painter, row.translated(width, 0), Qt::AlignLeft | Qt::AlignVCenter, hint);
  }
  if (!hasTimeTitle()) return;
  const QRectF below(m_plot.left(), m_area.bottom() - 1.5 * m_em, m_plot.width(), 1.3 * m_em);
  painter.setPen(colours.text2);
  paintText(painter, below, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("← faster"));
  painter.setFont(strong);
  painter.setPen(colours.text);
  paintText(painter, below, Qt::AlignCenter, QStringLiteral("Time of one picture"));
}

}  // namespace hogelscope
