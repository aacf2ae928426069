// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_chart.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <utility>

#include "chart/plot_painting.h"

namespace hogelscope {

namespace {

/// The ways to save time, in the order of ChartColours::series and markCorners().
enum class Family : std::size_t { lens, size, leakage, sampling, several };
constexpr std::array familyNames{"lens", "size", "leakage", "sampling", "several"};

Family familyOf(const TradeoffRow& row) {
  const std::array differs{row.lens != "exact" || row.precision != "double", row.scale > 1,
                           row.psf != "full",
                           row.reconstruction != "nearest" || row.samples > 1 || row.isOfPupil};
  const auto count = std::ranges::count(differs, true);
  if (count > 1) return Family::several;
  return count == 0 ? Family::lens : Family(std::ranges::find(differs, true) - differs.begin());
}

void paintShape(QPainter& painter, const QPointF& centre, double radius, Family family,
                const ChartColours& colours, bool isHollow) {
  const QColor colour =
      family == Family::several ? colours.text2 : colours.series[std::size_t(family)];
  painter.setPen(QPen(colour, 1.5));
  painter.setBrush(isHollow ? colours.background : colour);
  const std::size_t mark = family == Family::several ? 0 : std::size_t(family);
  paintMark(painter, centre, mark == 0 ? radius : 0.9 * radius, mark);
}

void paintRing(QPainter& painter, const QPointF& centre, double radius, const QColor& colour) {
  painter.setPen(QPen(colour, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(centre, radius, radius);
}

/// Returns the legend's height; 0 in a chart that is too small for one.
double legendHeight(const QSizeF& size, double em) {
  return size.height() < 22 * em ? 0 : 2.2 * em;
}

}  // namespace

void paintMarker(QPainter& painter, const QPointF& centre, double radius, const TradeoffRow& row,
                 const ChartColours& colours) {
  paintShape(painter, centre, radius, familyOf(row), colours, !row.isPareto);
}

QColor ringColour(Purpose purpose, const ChartColours& colours) {
  if (purpose == Purpose::movingView) return colours.accent;
  return purpose == Purpose::paper ? colours.series[1] : colours.text;
}

TradeoffChart::TradeoffChart(std::vector<TradeoffRow> rows, std::string question)
    : m_rows(std::move(rows)), m_question(std::move(question)) {}

TradeoffAxes TradeoffChart::axes(const QSizeF& size, const QFont& font) const {
  const double legend = legendHeight(size, QFontInfo(font).pixelSize());
  return {m_rows, {0, 0, size.width(), size.height() - legend}, font};
}

void TradeoffChart::paint(QPainter& painter, const QSizeF& size,
                          const ChartColours& colours) const {
  paintAll(painter, size, colours, Names::ofFront);
}

void TradeoffChart::paintFile(QPainter& painter, const QSizeF& size) const {
  TradeoffChart(m_rows, m_question).paintAll(painter, size, printColours(), Names::all);
}

std::optional<std::size_t> TradeoffChart::rowAt(const QPointF& place, const QSizeF& size,
                                                const QFont& font) const {
  const TradeoffAxes axes = this->axes(size, font);
  double nearest = axes.em();
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < m_rows.size(); ++k) {
    const std::optional<QPointF> point = axes.positionOf(m_rows[k]);
    const double distance = point ? QLineF(*point, place).length() : nearest;
    if (distance >= nearest) continue;
    nearest = distance;
    found = k;
  }
  if (found) return found;
  for (const PlacedName& name : placeNames(m_rows, axes, Names::ofFront))
    if (name.box.contains(place)) found = name.row;
  return found;
}

void TradeoffChart::paintAll(QPainter& painter, const QSizeF& size, const ChartColours& colours,
                             Names which) const {
  const TradeoffAxes axes = this->axes(size, painter.font());
  const std::vector<PlacedName> names = placeNames(m_rows, axes, which);
  std::vector<QRectF> gaps;
  gaps.reserve(names.size());
  for (const PlacedName& name : names) gaps.push_back(name.box);
  axes.paint(painter, colours, QString::fromStdString(m_question) + ", RMS in code values", gaps);
  painter.setPen(QPen(colours.text, 2));
  for (const QLineF& step : paretoSteps(m_rows, axes)) painter.drawLine(step);
  painter.setPen(QPen(colours.text2, 1));  // mostly shorter than the markers
  QPainterPath betweenNames;
  betweenNames.addRect({{0, 0}, size});
  for (const QRectF& gap : gaps) betweenNames.addRect(gap);
  for (const QRectF& caption : axes.captionBoxes()) betweenNames.addRect(caption);
  painter.save();
  painter.setClipPath(betweenNames);
  for (const std::size_t row : fastToSlow(m_rows)) {
    painter.drawLine(axes.quartilesOf(m_rows[row]));
    painter.drawLine(axes.errorBarOf(m_rows[row]));
  }
  painter.restore();
  paintMarkers(painter, axes, colours);
  for (const PlacedName& name : names) {
    painter.setPen(m_selected == name.row      ? colours.accent
                   : m_rows[name.row].isPareto ? colours.text
                                               : colours.text2);
    paintText(painter, name.box, Qt::AlignCenter, name.text);
  }
  if (m_pointed)
    paintRing(painter, *axes.positionOf(m_rows[*m_pointed]), 0.75 * axes.em(), colours.text);
  const double legend = legendHeight(size, axes.em());
  if (legend == 0) return;
  QStringList hints{"hollow: beaten by another"};
  if (std::ranges::all_of(m_rows, &TradeoffRow::isSampled))
    hints.prepend("on part of the pixels");
  else if (std::ranges::any_of(m_rows, &TradeoffRow::isSampled))
    hints.prepend("* on part of the pixels");
  if (which == Names::ofFront) hints += "hover names, click renders";
  const QRectF box(axes.em(), size.height() - legend, size.width() - 2 * axes.em(), legend);
  paintLegend(painter, box, colours, hints);
}

/// Paints the markers, more important ones on top, and rings around the recommended ones.
void TradeoffChart::paintMarkers(QPainter& painter, const TradeoffAxes& axes,
                                 const ChartColours& colours) const {
  const double radius = 0.4 * axes.em();
  for (const bool isPareto : {false, true})
    for (const std::size_t row : fastToSlow(m_rows))
      if (m_rows[row].isPareto == isPareto)
        paintMarker(painter, *axes.positionOf(m_rows[row]), radius, m_rows[row], colours);
  std::vector<int> rings(m_rows.size());
  for (const Purpose purpose : purposes)
    if (const auto row = recommended(m_rows, purpose))
      paintRing(painter, *axes.positionOf(m_rows[*row]), (0.85 + 0.25 * rings[*row]++) * axes.em(),
                ringColour(purpose, colours));
  if (!m_selected) return;
  const QPointF point = *axes.positionOf(m_rows[*m_selected]);
  QColor halo = colours.accent;
  halo.setAlphaF(0.3F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(halo);
  painter.drawEllipse(point, 1.2 * axes.em(), 1.2 * axes.em());
}

/// Paints what the shapes mean, and the first hints, as many as fit.
void TradeoffChart::paintLegend(QPainter& painter, const QRectF& box, const ChartColours& colours,
                                QStringList hints) const {
  const double em = QFontInfo(painter.font()).pixelSize();
  const QFontMetricsF metrics(painter.font());
  double x = box.left();
  const double y = box.center().y();
  const auto entry = [&](double symbol, const QString& words) {
    painter.setPen(colours.text2);
    paintText(painter, {x + symbol, box.top(), box.width(), box.height()},
              Qt::AlignLeft | Qt::AlignVCenter, words);
    x += symbol + metrics.horizontalAdvance(words) + 1.5 * em;
  };
  painter.setPen(QPen(colours.text, 2));
  const QPointF corner(x + em, y - 0.3 * em);
  painter.drawPolyline(QPolygonF{QPointF(x, corner.y()), corner, corner + QPointF(0, 0.6 * em),
                                 corner + QPointF(em, 0.6 * em)});
  entry(2.6 * em, QStringLiteral("Pareto front"));
  for (std::size_t k = 0; k < familyNames.size(); ++k) {
    if (std::ranges::find(m_rows, Family(k), familyOf) == m_rows.end()) continue;
    paintShape(painter, {x + 0.4 * em, y}, 0.4 * em, Family(k), colours, false);
    entry(1.3 * em, familyNames[k]);
  }
  const auto room = box.right() - x;
  while (!hints.isEmpty() && metrics.horizontalAdvance(hints.join(" · ")) > room)
    hints.removeLast();
  paintText(painter, box, Qt::AlignRight | Qt::AlignVCenter, hints.join(" · "));
}

}  // namespace hogelscope
