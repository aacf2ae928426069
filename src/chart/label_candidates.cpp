// SPDX-License-Identifier: BSD-3-Clause
// Places for a label, with their prices.
#include "chart/label_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hogelscope {

namespace {

constexpr double besideGap = 6.0;  // up to this far from its marker a label needs no leader

// What a label pays, in points of distance from its marker.
constexpr double perLineCovered = 30;
constexpr double perLineFollowed = 120;
constexpr double perObstacleCrossed = 60;
constexpr double perNeighbour = 12;  // another marker so close that it might be the one meant
constexpr double perOtherArea = 40;  // than the point's own

/// The box on the side of the point that the direction shows, `gap` away from the marker.
QRectF beside(const LabelRequest& request, double gap, const QPointF& direction) {
  const auto side = [](double part) {
    return std::abs(part) < 0.3 ? 0.0 : std::copysign(0.5, part);
  };
  QRectF box({0, 0}, request.size);
  box.moveCenter(request.point + (request.radius + gap) * direction +
                 QPointF(side(direction.x()) * request.size.width(),
                         side(direction.y()) * request.size.height()));
  return box;
}

LabelPlace placeAt(const LabelRequest& request, const QRectF& box) {
  QLineF leader(request.point, nearestPoint(box, request.point));
  if (leader.length() <= request.radius + besideGap) return {box, std::nullopt};
  leader.setP1(leader.pointAt((request.radius + 1) / leader.length()));
  return {box, leader};
}

/// The leader sets out along the line, so that the two cannot be told apart.
bool follows(const QLineF& leader, const QLineF& line) {
  const QRectF near = grown(QRectF(line.p1(), line.p2()).normalized(), 3);
  return near.contains(leader.p1()) && near.contains(leader.pointAt(12 / leader.length()));
}

/// Places of one label that are free of everything but labels, the cheapest first.
class CandidateList {
 public:
  CandidateList(const LabelRequest& request, const LabelSurroundings& around)
      : m_request(request), m_around(around) {}

  std::vector<LabelCandidate> near() {
    constexpr std::array gaps{0.0, 2.5, 7.0, 12.0, 18.0,  25.0,  33.0, 42.0,
                              52., 66., 82., 100., 125.0, 155.0, 190.0};
    constexpr int directions = 16;
    for (const double gap : gaps)
      for (int k = 0; k < directions; ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        const QPointF direction(std::cos(angle), -std::sin(angle));
        // To the right is where readers look first; steep leaders are easier to follow than flat.
        const double taste = 1.5 * (1 - direction.x()) + 0.3 * gap * std::abs(direction.x());
        take(beside(m_request, m_request.gap + gap, direction), gap + taste);
      }
    return sorted();
  }

  /// The last resort: all over the areas.
  std::vector<LabelCandidate> anywhere() {
    for (const QRectF& area : m_around.areas)
      for (double y = area.top() + labelMargin; y < area.bottom(); y += 6)
        for (double x = area.left() + labelMargin; x < area.right(); x += 12) {
          const QRectF box({x, y}, m_request.size);
          take(box, QLineF(m_request.point, nearestPoint(box, m_request.point)).length());
        }
    return sorted();
  }

 private:
  void take(const QRectF& box, double distance) {
    const QRectF wide = grown(box, labelMargin);
    const auto holds = [&](const QRectF& area) { return area.contains(wide); };
    const auto area = std::find_if(m_around.areas.begin(), m_around.areas.end(), holds);
    const auto covers = [&](const QRectF& obstacle) { return wide.intersects(obstacle); };
    if (area == m_around.areas.end() ||
        std::any_of(m_around.obstacles.begin(), m_around.obstacles.end(), covers))
      return;
    const LabelPlace place = placeAt(m_request, box);
    const double abroad = area->contains(m_request.point) ? 0 : perOtherArea;
    m_all.push_back({place, m_request.weight * (distance + abroad + priceOf(place))});
  }

  double priceOf(const LabelPlace& place) const {
    double price = 0;
    for (const QLineF& line : m_around.lines) {
      if (meets(line, place.box)) price += perLineCovered;
      if (place.leader && follows(*place.leader, line)) price += perLineFollowed;
    }
    for (const QRectF& obstacle : m_around.obstacles) {
      if (obstacle.contains(m_request.point)) continue;  // its own marker
      if (place.leader && meets(*place.leader, obstacle)) price += perObstacleCrossed;
      if (!place.leader && obstacle.intersects(grown(place.box, 4))) price += perNeighbour;
    }
    return price;
  }

  std::vector<LabelCandidate> sorted() {
    std::stable_sort(
        m_all.begin(), m_all.end(),
        [](const LabelCandidate& a, const LabelCandidate& b) { return a.price < b.price; });
    return std::move(m_all);
  }

  const LabelRequest& m_request;
  const LabelSurroundings& m_around;
  std::vector<LabelCandidate> m_all;
};

}  // namespace

/// By Liang and Barsky's clipping.
bool meets(const QLineF& line, const QRectF& box) {
  const auto [left, right] = std::minmax({line.x1(), line.x2()});
  const auto [top, bottom] = std::minmax({line.y1(), line.y2()});
  if (right < box.left() || left > box.right() || bottom < box.top() || top > box.bottom())
    return false;  // most are far away
  double enter = 0;
  double leave = 1;
  const auto clip = [&](double direction, double room) {
    if (direction == 0) return room >= 0;
    const double at = room / direction;
    if (direction < 0) enter = std::max(enter, at);
    if (direction > 0) leave = std::min(leave, at);
    return enter <= leave;
  };
  return clip(-line.dx(), line.x1() - box.left()) && clip(line.dx(), box.right() - line.x1()) &&
         clip(-line.dy(), line.y1() - box.top()) && clip(line.dy(), box.bottom() - line.y1());
}

QPointF nearestPoint(const QRectF& box, const QPointF& to) {
  return {std::clamp(to.x(), box.left(), box.right()), std::clamp(to.y(), box.top(), box.bottom())};
}

QRectF grown(const QRectF& box, double by) {
  return box.adjusted(-by, -by, by, by);
}

std::vector<LabelCandidate> candidatesNear(const LabelRequest& request,
                                           const LabelSurroundings& around) {
  return CandidateList(request, around).near();
}

std::vector<LabelCandidate> candidatesAnywhere(const LabelRequest& request,
                                               const LabelSurroundings& around) {
  return CandidateList(request, around).anywhere();
}

}  // namespace hogelscope
