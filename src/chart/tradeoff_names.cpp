// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_names.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <array>
#include <utility>

#include "chart/recommendations.h"

namespace hogelscope {

namespace {

QRectF grown(const QRectF& box, double by) {
  return box.adjusted(-by, -by, by, by);
}

bool meetsAny(const QRectF& box, const std::vector<QRectF>& others) {
  return std::ranges::any_of(others, [&](const QRectF& other) { return other.intersects(box); });
}

QRectF markerOf(const std::vector<TradeoffRow>& rows, std::size_t row, const TradeoffAxes& axes) {
  return grown({*axes.positionOf(rows[row]), QSizeF()}, markerRadius(rows, row, axes.em()));
}

QStringList purposeWords(const std::vector<TradeoffRow>& rows, std::size_t row, Names which) {
  QStringList words;
  if (which == Names::all && forMovingView(rows) == row) words += "moving view";
  if (rows[row].isDefault) words += "default";
  if (which == Names::all && forPaper(rows) == row) words += "paper";
  return words;
}

/// A name to be placed, of a row or of the first of some whose markers overlap.
struct Label {
  std::size_t row = 0;
  QRectF markers;
  QStringList purposes;
  int alike = 0;  ///< the number of further rows

  [[nodiscard]] QString text(const std::vector<TradeoffRow>& rows) const {
    QString words = nameOf(rows, row);
    if (!purposes.isEmpty()) words += " (" + purposes.join(", ") + ")";
    return alike > 0 ? words + QStringLiteral(" and %1 alike").arg(alike) : words;
  }
};

/// Returns the labels in the order in which they get a place: recommended rows, the front, others.
std::vector<Label> labelsOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                            Names which) {
  std::vector<Label> labels;
  for (const std::size_t row : fastToSlow(rows))
    labels.push_back({row, markerOf(rows, row, axes), purposeWords(rows, row, which)});
  const auto rank = [&rows](const Label& label) {
    return !label.purposes.isEmpty() ? 0 : rows[label.row].isPareto ? 1 : 2;
  };
  std::ranges::stable_sort(labels, {}, rank);
  std::vector<Label> merged;
  for (const Label& label : labels) {
    const auto same = std::ranges::find_if(merged, [&](const Label& other) {
      return rank(label) == 2 && !rows[other.row].isPareto &&
             (other.markers.contains(label.markers.center()) ||
              label.markers.contains(other.markers.center()));
    });
    if (same == merged.end()) {
      merged.push_back(label);
    } else {
      ++same->alike;
      same->markers |= label.markers;
    }
  }
  if (which == Names::ofFront)
    std::erase_if(merged, [&](const Label& label) { return rank(label) == 2; });
  return merged;
}

std::vector<QRectF> boxesOf(const std::vector<QLineF>& lines) {
  std::vector<QRectF> boxes;
  for (const QLineF& line : lines)
    boxes.push_back(grown(QRectF(line.p1(), line.p2()).normalized(), 1));
  return boxes;
}

/// Returns the areas that a name must not cover.
std::vector<QRectF> obstaclesOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes) {
  std::vector<QRectF> obstacles = axes.captionBoxes();
  std::vector<QLineF> lines = paretoSteps(rows, axes);
  for (const std::size_t row : fastToSlow(rows)) {
    obstacles.push_back(markerOf(rows, row, axes));
    lines.push_back(axes.quartilesOf(rows[row]));
  }
  std::ranges::copy(boxesOf(lines), std::back_inserter(obstacles));
  return obstacles;
}

/// Returns the boxes beside the markers, the best first. For the front these are below left, where
/// nothing can be that is not on the front; the others start opposite.
std::vector<QRectF> placesOf(const QRectF& markers, const QSizeF& size, bool isOnFront) {
  constexpr std::array right{-1., -1., -1., -.5, -1., 0., -1., .5, -.5, 0., .5, 1., 1., 1., 1., 1.};
  constexpr std::array down{.5, 0., 1., 1., -.5, 1., -1., 1., -1., -1., -1., -1., -.5, 0., .5, 1.};
  const QSizeF reach = (markers.size() + size) / 2;
  const double sign = isOnFront ? 1 : -1;
  std::vector<QRectF> places;
  for (const double gap : {2.0, 6.0, 10.0})
    for (std::size_t k = 0; k < right.size(); ++k) {
      QRectF box({0, 0}, size);
      box.moveCenter(markers.center() + sign * QPointF(right[k] * (reach.width() + gap),
                                                       down[k] * (reach.height() + gap)));
      places.push_back(box);
    }
  return places;
}

}  // namespace

std::vector<std::size_t> fastToSlow(const std::vector<TradeoffRow>& rows) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (isMeasured(rows[k])) order.push_back(k);
  std::ranges::stable_sort(
      order, {}, [&](std::size_t k) { return std::pair(rows[k].milliseconds, -rows[k].rmse); });
  return order;
}

double markerRadius(const std::vector<TradeoffRow>& rows, std::size_t row, double em) {
  const auto rings = std::ranges::count_if(
      purposes, [&](Purpose purpose) { return recommended(rows, purpose) == row; });
  return (rings > 0 ? 0.6 + 0.25 * double(rings) : 0.4) * em;
}

QString nameOf(const std::vector<TradeoffRow>& rows, std::size_t row) {
  const bool isOdd = rows[row].isSampled && !std::ranges::all_of(rows, &TradeoffRow::isSampled);
  return QString::fromStdString(rows[row].method) + (isOdd ? "*" : "");
}

std::vector<PlacedName> placeNames(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                                   Names which) {
  std::vector<QRectF> obstacles = obstaclesOf(rows, axes);
  const std::vector<QRectF> guides = boxesOf(axes.guides());
  const QFontMetricsF metrics(axes.font());
  std::vector<PlacedName> names;
  for (const Label& label : labelsOf(rows, axes, which)) {
    const QString words = label.text(rows);
    const QSizeF size(metrics.horizontalAdvance(words) + 2, metrics.height());
    const std::vector<QRectF> places = placesOf(label.markers, size, rows[label.row].isPareto);
    const auto isFree = [&](const QRectF& box) {
      const auto holdsBoth = [&](const QRectF& area) {
        return area.contains(grown(box, 1)) && area.contains(label.markers.center());
      };
      return std::ranges::any_of(axes.areas(), holdsBoth) && !meetsAny(grown(box, 1), obstacles);
    };
    auto found = std::ranges::find_if(
        places, [&](const QRectF& box) { return isFree(box) && !meetsAny(box, guides); });
    if (found == places.end()) found = std::ranges::find_if(places, isFree);
    if (found == places.end()) continue;
    names.push_back({label.row, words, *found});
    obstacles.push_back(*found);
  }
  return names;
}

std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes) {
  std::vector<QLineF> steps;
  std::optional<QPointF> last;
  for (const std::size_t k : fastToSlow(rows)) {
    if (!rows[k].isPareto) continue;
    const QPointF point = *axes.positionOf(rows[k]);
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
