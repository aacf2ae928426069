// SPDX-License-Identifier: BSD-3-Clause
// The chart of speed against accuracy, painted.
#include "chart/tradeoff_chart.h"

#include <QFontMetricsF>
#include <algorithm>
#include <utility>

#include "chart/recommendations.h"

namespace hogelscope {

namespace {

// Blue and vermilion are told apart by colour-blind eyes (Okabe and Ito); words say the same in
// grey.
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

void disc(QPainter& painter, const QPointF& centre, double radius) {
  painter.drawEllipse(centre, radius, radius);
}

}  // namespace

TradeoffChart::TradeoffChart(std::vector<TradeoffRow> rows, std::string question)
    : m_rows(std::move(rows)), m_question(std::move(question)) {}

void TradeoffChart::paint(QPainter& painter, const QSizeF& size) const {
  painter.save();
  const TradeoffAxes axes(m_rows, size);
  const TradeoffLabels labels = labelsOf(m_rows, axes, painter.font());
  axes.paint(painter, QString::fromStdString(m_question));
  paintLegend(painter, axes);
  if (labels.labels.empty()) {
    painter.setFont(sized(painter.font(), 1.25 * axes.em()));
    text(painter, axes.areas().front(), Qt::AlignHCenter, QStringLiteral("Nothing measured yet"));
  }
  painter.setPen(QPen(paleGrey, 0.8));
  for (const TradeoffLabel& label : labels.labels)
    if (label.leader) painter.drawLine(*label.leader);
  paintFront(painter, axes);
  for (const TradeoffLabel& label : labels.labels)
    axes.paintGround(painter, label.box);  // lines pass behind names
  paintMarkers(painter, axes);
  painter.setFont(labels.font);
  for (const TradeoffLabel& label : labels.labels)
    label.purposes.empty() ? paintNames(painter, label) : paintCallout(painter, label);
  painter.restore();
}

std::optional<std::size_t> TradeoffChart::rowAt(const QPointF& place, const QSizeF& size) const {
  const TradeoffAxes axes(m_rows, size);
  double nearest = 6;
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < m_rows.size(); ++k) {
    const std::optional<QPointF> point = axes.place(m_rows[k]);
    const double distance = point ? QLineF(*point, place).length() : nearest;
    if (distance >= nearest) continue;
    nearest = distance;
    found = k;
  }
  return found;
}

std::vector<QRectF> TradeoffChart::nameBoxes(const QSizeF& size, const QFont& font) const {
  std::vector<QRectF> boxes(m_rows.size());
  for (const TradeoffLabel& label : labelsOf(m_rows, TradeoffAxes(m_rows, size), font).labels)
    for (std::size_t k = 0; k < label.rows.size(); ++k)
      boxes[label.rows[k]] = label.purposes.empty() ? label.line(k) : label.box;
  return boxes;
}

void TradeoffChart::paintLegend(QPainter& painter, const TradeoffAxes& axes) const {
  painter.save();
  painter.setFont(sized(painter.font(), 0.9 * axes.em()));
  const double em = axes.em();
  const double y = 2.7 * em;
  double x = 1.5 * em;
  const auto entry = [&](const QColor& colour, double radius, const QString& words) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    disc(painter, {x, y}, radius);
    painter.setPen(colour);
    text(painter, {x + em, y - em, 300, 2 * em}, Qt::AlignLeft, words);
    x += QFontMetricsF(painter.font()).horizontalAdvance(words) + 3 * em;
  };
  entry(ink, 4, QStringLiteral("no other is both faster and more accurate"));
  entry(grey, 4, QStringLiteral("others"));
  painter.restore();
}

void TradeoffChart::paintFront(QPainter& painter, const TradeoffAxes& axes) const {
  painter.setPen(QPen(ink, 1.6));
  for (const QLineF& step : paretoSteps(m_rows, axes)) painter.drawLine(step);
}

/// The more a point has to say, the higher it lies.
void TradeoffChart::paintMarkers(QPainter& painter, const TradeoffAxes& axes) const {
  const auto importance = [&](std::size_t k) {
    return m_selected == k ? 3 : !purposesOf(m_rows, k).empty() ? 2 : m_rows[k].isPareto ? 1 : 0;
  };
  for (int level = 0; level <= 3; ++level)
    for (std::size_t k = 0; k < m_rows.size(); ++k)
      if (const auto point = axes.place(m_rows[k]); point && importance(k) == level)
        paintMarker(painter, *point, k);
}

void TradeoffChart::paintMarker(QPainter& painter, const QPointF& point, std::size_t row) const {
  const std::vector<Purpose> purposes = purposesOf(m_rows, row);
  const double radius = markerRadius(purposes);
  if (m_selected == row) {
    painter.setPen(QPen(ink, 1));
    painter.setBrush(highlight);
    disc(painter, point, radius + 5);
  }
  const bool hasRing = m_rows[row].isDefault;
  if (hasRing) {
    painter.setPen(QPen(ink, 2));
    painter.setBrush(Qt::white);
    disc(painter, point, radius - 1);
  }
  painter.setPen(QPen(Qt::white, 1));
  painter.setBrush(!purposes.empty()      ? colourOf(purposes.front())
                   : m_rows[row].isPareto ? ink
                                          : grey);
  disc(painter, point, hasRing ? radius - 3.5 : radius);
}

void TradeoffChart::paintNames(QPainter& painter, const TradeoffLabel& label) const {
  QFont font = painter.font();
  const bool isRight = label.box.center().x() < label.point.x() - label.box.width() / 4;
  for (std::size_t k = 0; k < label.rows.size(); ++k) {
    const std::size_t row = label.rows[k];
    if (m_selected == row) painter.fillRect(label.line(k), highlight);
    font.setBold(m_rows[row].isPareto || m_selected == row);
    painter.setFont(font);
    painter.setPen(m_rows[row].isPareto || m_selected == row ? ink : grey);
    text(painter, label.line(k), isRight ? Qt::AlignRight : Qt::AlignLeft,
         QString::fromStdString(m_rows[row].method));
  }
}

void TradeoffChart::paintCallout(QPainter& painter, const TradeoffLabel& label) const {
  const TradeoffRow& row = m_rows[label.rows.front()];
  const QColor colour = colourOf(label.purposes.front());
  QFont font = painter.font();
  painter.save();
  painter.setPen(QPen(colour, 2));
  if (label.leader) painter.drawLine(*label.leader);
  painter.setBrush(m_selected == label.rows.front() ? highlight : Qt::white);
  painter.drawRect(label.box);
  font.setBold(true);
  painter.setFont(font);
  std::size_t line = 0;
  for (const Purpose purpose : label.purposes) {
    painter.fillRect(label.line(line), colourOf(purpose));
    painter.setPen(Qt::white);
    text(painter, label.line(line++), Qt::AlignHCenter, words(purpose));
  }
  painter.setPen(ink);
  text(painter, label.line(line++), Qt::AlignHCenter, QString::fromStdString(row.method));
  font.setBold(false);
  painter.setFont(font);
  text(painter, label.line(line), Qt::AlignHCenter, figures(row));
  painter.restore();
}

}  // namespace hogelscope
