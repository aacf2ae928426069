// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_numbers.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "chart/recommendations.h"

namespace hogelscope {

namespace {

QRectF grown(const QRectF& box, double by) {
  return box.adjusted(-by, -by, by, by);
}

QRectF square(const QPointF& centre, double radius) {
  return {centre - QPointF(radius, radius), centre + QPointF(radius, radius)};
}

bool meetsAny(const QRectF& box, const std::vector<QRectF>& others) {
  return std::ranges::any_of(others, [&](const QRectF& other) { return other.intersects(box); });
}

QRectF markerOf(const std::vector<TradeoffRow>& rows, std::size_t row, const TradeoffAxes& axes) {
  return square(*axes.positionOf(rows[row]), axes.em() * markerRadius(rows, row));
}

/// Groups points whose markers overlap. Groups with many numbers come first, because large boxes
/// have the fewest places.
std::vector<PointNumbers> groupsOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes) {
  std::vector<PointNumbers> groups;
  std::size_t number = 0;
  for (const std::size_t row : numbered(rows)) {
    const QRectF marker = markerOf(rows, row, axes);
    auto group = std::ranges::find_if(groups, [&](const PointNumbers& other) {
      return other.markers.contains(marker.center()) || marker.contains(other.markers.center());
    });
    if (group == groups.end()) group = groups.insert(group, {{}, marker, {}, {}});
    group->numbers.push_back(++number);
    group->markers |= marker;
  }
  std::ranges::stable_sort(groups, std::greater(),
                           [](const PointNumbers& group) { return group.numbers.size(); });
  return groups;
}

/// Areas that a number must not cover.
struct Obstacles {
  std::vector<QRectF> things;  ///< a leader must not cross them either
  std::vector<QRectF> lines;
};

Obstacles obstaclesOf(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes,
                      const QFont& font) {
  Obstacles obstacles{{axes.zeroCaption(font)}, {}};
  for (const std::size_t row : numbered(rows))
    obstacles.things.push_back(markerOf(rows, row, axes));
  for (const auto& lines : {paretoSteps(rows, axes), axes.guides()})
    for (const QLineF& line : lines)
      obstacles.lines.push_back(grown(QRectF(line.p1(), line.p2()).normalized(), 0.5));
  return obstacles;
}

/// Returns the box beside the markers at a distance of `gap`; the larger component of `direction`
/// is 1.
QRectF boxBeside(const QRectF& markers, const QSizeF& size, const QPointF& direction, double gap) {
  const QSizeF reach = (markers.size() + size) / 2;
  QRectF box({0, 0}, size);
  box.moveCenter(markers.center() + QPointF(direction.x() * (reach.width() + gap),
                                            direction.y() * (reach.height() + gap)));
  return box;
}

QPointF nearestIn(const QRectF& box, const QPointF& point) {
  return {std::clamp(point.x(), box.left(), box.right()),
          std::clamp(point.y(), box.top(), box.bottom())};
}

/// Returns small squares along the line.
std::vector<QRectF> dotsOn(const QLineF& line) {
  const int last = 1 + static_cast<int>(line.length() / 3);
  std::vector<QRectF> dots;
  for (int k = 0; k <= last; ++k)
    dots.push_back(square(line.pointAt(k / static_cast<double>(last)), 1));
  return dots;
}

/// Places a group at the first free place, and adds its box and leader to the obstacles.
bool placeGroup(PointNumbers& group, const QSizeF& size, const std::vector<QRectF>& areas,
                Obstacles& obstacles, bool mayCoverLines) {
  // Sides, corners, and the directions between them.
  constexpr std::array right{1., 0., 0., -1., 1., 1., -1., -1., 1., 1., .5, .5, -.5, -.5, -1., -1.};
  constexpr std::array down{0., -1., 1., 0., -1., 1., -1., 1., -.5, .5, -1., 1., -1., 1., -.5, .5};
  for (const double gap : {1.0, 5.0, 9.0, 14.0, 20.0, 28.0, 38.0, 50.0})
    for (std::size_t k = 0; k < right.size(); ++k) {
      const QRectF box = boxBeside(group.markers, size, {right[k], down[k]}, gap);
      const QRectF wide = grown(box, 1);
      const auto holds = [&](const QRectF& area) { return area.contains(wide); };
      if (std::ranges::none_of(areas, holds) || meetsAny(wide, obstacles.things) ||
          (!mayCoverLines && meetsAny(wide, obstacles.lines)))
        continue;
      const QLineF leader(nearestIn(grown(group.markers, 2), box.center()),
                          nearestIn(box, group.markers.center()));
      const std::vector<QRectF> dots = gap > 2 ? dotsOn(leader) : std::vector<QRectF>();
      const auto isBlocked = [&](const QRectF& dot) { return meetsAny(dot, obstacles.things); };
      if (std::ranges::any_of(dots, isBlocked)) continue;
      group.box = box;
      if (!dots.empty()) group.leader = leader;
      obstacles.things.push_back(box);
      obstacles.things.insert(obstacles.things.end(), dots.begin(), dots.end());
      return true;
    }
  return false;
}

}  // namespace

std::vector<std::size_t> numbered(const std::vector<TradeoffRow>& rows) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (isMeasured(rows[k])) order.push_back(k);
  std::ranges::stable_sort(
      order, {}, [&](std::size_t k) { return std::pair(rows[k].milliseconds, -rows[k].rmse); });
  return order;
}

double markerRadius(const std::vector<TradeoffRow>& rows, std::size_t row) {
  return rows[row].isDefault ? 0.6 : purposesOf(rows, row).empty() ? 0.27 : 0.4;
}

QString textOf(const PointNumbers& numbers) {
  QStringList texts;
  const auto& all = numbers.numbers;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t first = k;
    while (k + 1 < all.size() && all[k + 1] == all[k] + 1) ++k;
    if (k == first + 1) --k;  // two numbers are listed
    texts +=
        k == first ? QString::number(all[k]) : QStringLiteral("%1–%2").arg(all[first]).arg(all[k]);
  }
  return texts.join(", ");
}

std::vector<PointNumbers> numbersBesidePoints(const std::vector<TradeoffRow>& rows,
                                              const TradeoffAxes& axes, const QFont& font) {
  std::vector<PointNumbers> groups = groupsOf(rows, axes);
  Obstacles obstacles = obstaclesOf(rows, axes, font);
  const QFontMetricsF metrics(font);
  for (PointNumbers& group : groups) {
    const QSizeF size(metrics.horizontalAdvance(textOf(group)), metrics.capHeight() + 2);
    if (!placeGroup(group, size, axes.areas(), obstacles, false))
      placeGroup(group, size, axes.areas(), obstacles, true);
  }
  std::erase_if(groups, [](const PointNumbers& group) { return group.box.isEmpty(); });
  return groups;
}

std::vector<QLineF> paretoSteps(const std::vector<TradeoffRow>& rows, const TradeoffAxes& axes) {
  std::vector<QLineF> steps;
  std::optional<QPointF> last;
  for (const std::size_t k : numbered(rows)) {
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
