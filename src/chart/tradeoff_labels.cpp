// SPDX-License-Identifier: BSD-3-Clause
// Labels of the chart of speed against accuracy: what stands in which box.
#include "chart/tradeoff_labels.h"

#include <QFontMetricsF>
#include <algorithm>

#include "chart/labels.h"
#include "chart/recommendations.h"

namespace hogelscope {

namespace {

constexpr double together = 4;          // points that are so near share a box
constexpr std::size_t mostStacked = 6;  // names
constexpr double beside = 2.5;          // the gap between a name and its marker
constexpr double pointing = 12;         // leaves a callout a leader that is seen

/// All measured rows by time, so that a stack of names reads as the points lie.
std::vector<std::size_t> byTime(const std::vector<TradeoffRow>& rows) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (isMeasured(rows[k])) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const TradeoffRow& first = rows[a];
    const TradeoffRow& second = rows[b];
    return first.milliseconds < second.milliseconds ||
           (first.milliseconds == second.milliseconds && first.rmse > second.rmse);
  });
  return order;
}

/// Callouts first: they are larger and choose first.
std::vector<TradeoffLabel> boxesOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes) {
  std::vector<TradeoffLabel> callouts;
  std::vector<TradeoffLabel> names;
  for (const std::size_t k : byTime(rows)) {
    const QPointF point = *axes.place(rows[k]);
    const std::vector<Purpose> purposes = purposesOf(rows, k);
    const auto takesIt = [&](const TradeoffLabel& label) {
      return label.rows.size() < mostStacked && QLineF(label.point, point).length() <= together;
    };
    const auto stack = std::find_if(names.begin(), names.end(), takesIt);
    if (!purposes.empty())
      callouts.push_back({{k}, purposes, point, {}, {}});
    else if (stack != names.end())
      stack->rows.push_back(k);
    else
      names.push_back({{k}, {}, point, {}, {}});
  }
  // The larger a box, the fewer places it has.
  std::stable_sort(names.begin(), names.end(), [](const TradeoffLabel& a, const TradeoffLabel& b) {
    return a.rows.size() > b.rows.size();
  });
  callouts.insert(callouts.end(), names.begin(), names.end());
  return callouts;
}

QSizeF sizeOf(const TradeoffLabel& label, const std::vector<TradeoffRow>& rows, const QFont& font) {
  const QFontMetricsF metrics(font);
  double width = 0;
  const auto take = [&](const QString& text, bool isBold) {
    QFont own = font;
    own.setBold(isBold);
    width = std::max(width, QFontMetricsF(own).horizontalAdvance(text));
  };
  const bool isCallout = !label.purposes.empty();
  for (const Purpose purpose : label.purposes) take(words(purpose), true);
  for (const std::size_t k : label.rows)
    take(QString::fromStdString(rows[k].method), isCallout || rows[k].isPareto);
  if (isCallout) take(figures(rows[label.rows.front()]), false);
  const double edge = isCallout ? metrics.height() : 2;
  return {width + edge, metrics.height() * static_cast<double>(label.lines())};
}

LabelSurroundings surroundingsOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                                 const QFont& font) {
  LabelSurroundings around{axes.areas(), {}, paretoSteps(rows, axes)};
  const QRectF caption = axes.zeroCaption(font);
  if (!caption.isEmpty()) around.obstacles.push_back(caption);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::optional<QPointF> point = axes.place(rows[k]);
    if (!point) continue;
    const double radius = markerRadius(purposesOf(rows, k));
    around.obstacles.emplace_back(*point - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
  }
  return around;
}

/// Whether all found a place.
bool place(std::vector<TradeoffLabel>& boxes, const std::vector<TradeoffRow>& rows,
           const LabelSurroundings& around, const QFont& font) {
  std::vector<LabelRequest> requests;
  requests.reserve(boxes.size());
  for (const TradeoffLabel& label : boxes)
    requests.push_back({label.point, markerRadius(label.purposes), sizeOf(label, rows, font),
                        label.purposes.empty() ? beside : pointing,
                        label.purposes.empty() ? 1.0 : 3.0});
  const std::vector<std::optional<LabelPlace>> places = placeLabels(requests, around);
  bool isComplete = true;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    isComplete = isComplete && places[k].has_value();
    boxes[k].box = places[k] ? places[k]->box : QRectF();
    boxes[k].leader = places[k] ? places[k]->leader : std::nullopt;
  }
  return isComplete;
}

}  // namespace

std::vector<Purpose> purposesOf(const std::vector<TradeoffRow>& rows, std::size_t row) {
  std::vector<Purpose> purposes;
  if (forMovingView(rows) == row) purposes.push_back(Purpose::movingView);
  if (forPaper(rows) == row) purposes.push_back(Purpose::paper);
  if (rows[row].isDefault && isMeasured(rows[row])) purposes.push_back(Purpose::standard);
  return purposes;
}

double markerRadius(const std::vector<Purpose>& purposes) {
  const bool hasRing = std::count(purposes.begin(), purposes.end(), Purpose::standard) > 0;
  return hasRing ? 9 : purposes.empty() ? 4 : 6;
}

const char* words(Purpose purpose) {
  if (purpose == Purpose::movingView) return "for a moving view";
  if (purpose == Purpose::paper) return "for a paper";
  return "default";
}

std::size_t TradeoffLabel::lines() const {
  const bool isCallout = !purposes.empty();
  return purposes.size() + rows.size() + (isCallout ? 1 : 0);
}

QRectF TradeoffLabel::line(std::size_t k) const {
  const double height = box.height() / static_cast<double>(lines());
  return {box.left(), box.top() + height * static_cast<double>(k), box.width(), height};
}

QString figures(const TradeoffRow& row) {
  // Two digits, but no powers of ten for what takes long.
  const auto number = [](double value) {
    const bool isLong = value >= 99.5 && value < 1e6;
    return isLong ? QString::number(value, 'f', 0) : QString::number(value, 'g', 2);
  };
  return QStringLiteral("%1 ms, error %2").arg(number(row.milliseconds), number(row.rmse));
}

TradeoffLabels labelsOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                        const QFont& font) {
  std::vector<TradeoffLabel> boxes = boxesOf(rows, axes);
  const LabelSurroundings around = surroundingsOf(rows, axes, font);
  constexpr double leastReadable = 8;
  double size = axes.em();
  while (!place(boxes, rows, around, sized(font, size)) && size > leastReadable) size -= 1;
  std::erase_if(boxes, [](const TradeoffLabel& label) { return label.box.isEmpty(); });
  return {sized(font, size), boxes};
}

std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes) {
  std::vector<QLineF> steps;
  std::optional<QPointF> last;
  for (const std::size_t k : byTime(rows)) {
    if (!rows[k].isPareto) continue;
    const QPointF point = *axes.place(rows[k]);
    if (last) {
      const QPointF corner(point.x(), last->y());
      steps.emplace_back(*last, corner);
      steps.emplace_back(corner, point);
    }
    last = point;
  }
  return steps;
}

}  // namespace hogelscope
