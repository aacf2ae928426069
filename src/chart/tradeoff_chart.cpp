// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_chart.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "chart/recommendations.h"
#include "chart/tradeoff_numbers.h"

namespace hogelscope {

struct LegendLine {
  std::size_t row = 0;
  std::optional<Purpose> purpose;  ///< a purpose of the row above; empty for the row itself
  QRectF box;
};

/// The layout of the legend. Columns are distances from the lines' left edge; the marker precedes
/// the number.
struct TradeoffLegend {
  QFont font;
  double numberEnd = 0;
  double name = 0;
  double timeEnd = 0;  ///< 0 if there is no space for times and errors
  std::vector<LegendLine> lines;
};

namespace {

// Blue and vermilion differ for colour-blind readers (Okabe and Ito); texts tell the same in
// greyscale.
const QColor ink(20, 20, 20);
const QColor grey(110, 110, 110);
const QColor paleGrey(165, 165, 165);
const QColor highlight(240, 228, 66);

QColor colourOf(Purpose purpose) {
  if (purpose == Purpose::movingView) return {0, 90, 160};
  if (purpose == Purpose::paper) return {190, 75, 0};
  return ink;
}

void text(QPainter& painter, const QRectF& box, int flags, const QString& words) {
  painter.drawText(box, flags | Qt::TextSingleLine | Qt::TextDontClip | Qt::AlignVCenter, words);
}

/// Returns the right part of the chart; empty without measured rows.
QRectF legendArea(const std::vector<TradeoffRow>& rows, const QSizeF& size) {
  const double width = std::ranges::any_of(rows, isMeasured) ? 0.36 * size.width() : 0;
  return {size.width() - width, 0, width, size.height()};
}

void disc(QPainter& painter, const QPointF& centre, double radius) {
  painter.drawEllipse(centre, radius, radius);
}

double widest(const QStringList& texts, const QFont& font) {
  const QFontMetricsF metrics(font);
  double width = 0;
  for (const QString& text : texts) width = std::max(width, metrics.horizontalAdvance(text));
  return width;
}

/// Formats a value with two digits, without powers of ten up to a million.
QString figureText(double value) {
  const bool isLong = value >= 99.5 && value < 1e6;
  return isLong ? QString::number(value, 'f', 0) : QString::number(value, 'g', 2);
}

/// Returns the method's name, with an asterisk if it was measured on part of the pixels.
QString legendName(const TradeoffRow& row) {
  return QString::fromStdString(row.method) + (row.isSampled ? "*" : "");
}

/// Lays out the legend at the top of `area`, below a title line, in the largest font of at most
/// `size` that fits, from fast to slow.
TradeoffLegend legendOf(const std::vector<TradeoffRow>& rows, const QRectF& area, const QFont& font,
                        double size) {
  TradeoffLegend legend;
  QStringList names;
  QStringList times{"ms"};
  QStringList errors{"error"};
  for (const std::size_t row : numbered(rows)) {
    legend.lines.push_back({row, std::nullopt, {}});
    for (const Purpose purpose : purposesOf(rows, row)) legend.lines.push_back({row, purpose, {}});
    names += legendName(rows[row]);
    times += figureText(rows[row].milliseconds);
    errors += figureText(rows[row].rmse);
  }
  const double pitch = area.height() / static_cast<double>(legend.lines.size() + 1);
  constexpr double leastReadable = 7;
  constexpr double leastWithFigures = 10;
  for (;; --size) {
    legend.font = sized(font, size);
    const double em = QFontMetricsF(legend.font).height();
    legend.numberEnd = 1.5 * em + widest({QString::number(names.size())}, sized(font, size, true));
    legend.name = legend.numberEnd + 0.5 * em;
    const double nameEnd = legend.name + widest(names, sized(font, size, true));
    legend.timeEnd = area.width() - widest(errors, legend.font) - 0.6 * em;
    const bool hasFigures = nameEnd + 0.6 * em + widest(times, legend.font) <= legend.timeEnd;
    if (!hasFigures) legend.timeEnd = 0;
    const bool fits =
        1.05 * em <= pitch && nameEnd <= area.width() && (hasFigures || size < leastWithFigures);
    if (fits || size <= leastReadable) break;
  }
  const double height = std::min(pitch, 1.4 * QFontMetricsF(legend.font).height());
  double top = area.top();
  for (LegendLine& line : legend.lines)
    line.box = {area.left(), top += height, area.width(), height};
  return legend;
}

}  // namespace

TradeoffChart::TradeoffChart(std::vector<TradeoffRow> rows, std::string question)
    : m_rows(std::move(rows)), m_question(std::move(question)) {}

TradeoffAxes TradeoffChart::axes(const QSizeF& size) const {
  return {m_rows, {size.width() - legendArea(m_rows, size).width(), size.height()}};
}

TradeoffLegend TradeoffChart::legend(const QSizeF& size, const QFont& font) const {
  const double em = axes(size).em();
  const QRectF area = legendArea(m_rows, size).adjusted(0, 0.5 * em, -0.8 * em, -0.5 * em);
  return legendOf(m_rows, area, font, 0.9 * em);
}

void TradeoffChart::paint(QPainter& painter, const QSizeF& size) const {
  painter.save();
  const TradeoffAxes axes = this->axes(size);
  axes.paint(painter, QString::fromStdString(m_question));
  const TradeoffLegend legend = this->legend(size, painter.font());
  if (legend.lines.empty()) {
    painter.setFont(sized(painter.font(), 1.25 * axes.em()));
    text(painter, axes.areas().front(), Qt::AlignHCenter, QStringLiteral("Nothing measured yet"));
  } else {
    paintKey(painter, axes);
    paintFront(painter, axes);
    paintSpreads(painter, axes);
    paintMarkers(painter, axes);
    paintNumbers(painter, axes);
    paintLegend(painter, legend);
  }
  painter.restore();
}

std::optional<std::size_t> TradeoffChart::rowAt(const QPointF& place, const QSizeF& size) const {
  const TradeoffAxes axes = this->axes(size);
  double nearest = 6;
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < m_rows.size(); ++k) {
    const std::optional<QPointF> point = axes.positionOf(m_rows[k]);
    const double distance = point ? QLineF(*point, place).length() : nearest;
    if (distance >= nearest) continue;
    nearest = distance;
    found = k;
  }
  return found;
}

std::vector<QRectF> TradeoffChart::nameBoxes(const QSizeF& size, const QFont& font) const {
  std::vector<QRectF> boxes(m_rows.size());
  for (const LegendLine& line : legend(size, font).lines)
    if (!line.purpose) boxes[line.row] = line.box;
  return boxes;
}

void TradeoffChart::paintKey(QPainter& painter, const TradeoffAxes& axes) const {
  painter.save();
  painter.setFont(sized(painter.font(), 0.9 * axes.em()));
  const double em = axes.em();
  const double y = 2.7 * em;
  double x = 1.5 * em;
  const auto entry = [&](const QColor& colour, const QString& words) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    disc(painter, {x, y}, 0.27 * em);
    painter.setPen(colour);
    text(painter, {x + em, y - em, 300, 2 * em}, Qt::AlignLeft, words);
    x += QFontMetricsF(painter.font()).horizontalAdvance(words) + 3 * em;
  };
  entry(ink, QStringLiteral("Pareto front"));
  entry(grey, QStringLiteral("others"));
  painter.setPen(grey);
  if (std::ranges::any_of(m_rows, &TradeoffRow::isSampled))
    text(painter, {x, y - em, 300, 2 * em}, Qt::AlignLeft,
         QStringLiteral("* on part of the pixels"));
  painter.restore();
}

void TradeoffChart::paintFront(QPainter& painter, const TradeoffAxes& axes) const {
  painter.setPen(QPen(ink, 1.6));
  for (const QLineF& step : paretoSteps(m_rows, axes)) painter.drawLine(step);
}

/// Paints the interquartile ranges, which are mostly shorter than the markers.
void TradeoffChart::paintSpreads(QPainter& painter, const TradeoffAxes& axes) const {
  painter.setPen(QPen(grey, 0.1 * axes.em()));
  for (const std::size_t row : numbered(m_rows)) painter.drawLine(axes.quartilesOf(m_rows[row]));
}

/// Paints the markers, more important ones on top.
void TradeoffChart::paintMarkers(QPainter& painter, const TradeoffAxes& axes) const {
  const auto importance = [&](std::size_t k) {
    return m_selected == k ? 3 : !purposesOf(m_rows, k).empty() ? 2 : m_rows[k].isPareto ? 1 : 0;
  };
  for (int level = 0; level <= 3; ++level)
    for (std::size_t k = 0; k < m_rows.size(); ++k)
      if (const auto point = axes.positionOf(m_rows[k]); point && importance(k) == level)
        paintMarker(painter, *point, axes.em(), k);
}

void TradeoffChart::paintMarker(QPainter& painter, const QPointF& point, double em,
                                std::size_t row) const {
  const std::vector<Purpose> purposes = purposesOf(m_rows, row);
  const double radius = em * markerRadius(m_rows, row);
  if (m_selected == row) {
    painter.setPen(QPen(ink, 0.07 * em));
    painter.setBrush(highlight);
    disc(painter, point, radius + 0.2 * em);
  }
  const bool hasRing = m_rows[row].isDefault;
  if (hasRing) {
    painter.setPen(QPen(ink, 0.13 * em));
    painter.setBrush(Qt::white);
    disc(painter, point, radius - 0.07 * em);
  }
  painter.setPen(QPen(Qt::white, 0.07 * em));
  painter.setBrush(!purposes.empty()      ? colourOf(purposes.front())
                   : m_rows[row].isPareto ? ink
                                          : grey);
  disc(painter, point, hasRing ? radius - 0.23 * em : radius);
}

void TradeoffChart::paintNumbers(QPainter& painter, const TradeoffAxes& axes) const {
  painter.setFont(sized(painter.font(), std::max(9.0, 0.8 * axes.em()), true));
  const std::vector<std::size_t> rows = numbered(m_rows);
  for (const PointNumbers& group : numbersBesidePoints(m_rows, axes, painter.font())) {
    const bool isOnFront = std::ranges::any_of(
        group.numbers, [&](std::size_t number) { return m_rows[rows[number - 1]].isPareto; });
    painter.setPen(QPen(paleGrey, 0.8));
    if (group.leader) painter.drawLine(*group.leader);
    painter.setPen(isOnFront ? ink : grey);
    text(painter, group.box, Qt::AlignHCenter, textOf(group));
  }
}

void TradeoffChart::paintLegend(QPainter& painter, const TradeoffLegend& legend) const {
  const double height = legend.lines.front().box.height();
  painter.setFont(legend.font);
  painter.setPen(grey);
  QRectF head = legend.lines.front().box.translated(0, -height);
  text(painter, head.adjusted(legend.name, 0, 0, 0), Qt::AlignLeft, QStringLiteral("method"));
  if (legend.timeEnd > 0) {
    text(painter, head, Qt::AlignRight, QStringLiteral("error"));
    head.setWidth(legend.timeEnd);
    text(painter, head, Qt::AlignRight, QStringLiteral("ms"));
  }
  std::size_t number = 0;
  for (const auto& [row, purpose, box] : legend.lines) {
    if (!purpose) {
      paintLegendRow(painter, legend, box, row, ++number);
      continue;
    }
    const QRectF band = box.adjusted(legend.name, 1, 0, -1);
    painter.fillRect(band, colourOf(*purpose));
    painter.setPen(Qt::white);
    painter.setFont(sized(legend.font, legend.font.pixelSize(), true));
    text(painter, band, Qt::AlignHCenter, words(*purpose));
  }
}

void TradeoffChart::paintLegendRow(QPainter& painter, const TradeoffLegend& legend,
                                   const QRectF& box, std::size_t row, std::size_t number) const {
  const double height = box.height();
  const bool isStrong = m_rows[row].isPareto || m_selected == row;
  if (m_selected == row) painter.fillRect(box, highlight);
  paintMarker(painter, {box.left() + 0.5 * height, box.center().y()}, 0.8 * height, row);
  painter.setPen(isStrong ? ink : grey);
  painter.setFont(sized(legend.font, legend.font.pixelSize(), isStrong));
  text(painter, {box.left(), box.top(), legend.numberEnd, height}, Qt::AlignRight,
       QString::number(number));
  text(painter, box.adjusted(legend.name, 0, 0, 0), Qt::AlignLeft, legendName(m_rows[row]));
  if (legend.timeEnd == 0) return;
  painter.setFont(legend.font);
  text(painter, box, Qt::AlignRight, figureText(m_rows[row].rmse));
  text(painter, {box.left(), box.top(), legend.timeEnd, height}, Qt::AlignRight,
       figureText(m_rows[row].milliseconds));
}

}  // namespace hogelscope
