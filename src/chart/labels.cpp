// SPDX-License-Identifier: BSD-3-Clause
// Labels take the cheapest free place in turn; then those that did badly choose before their
// neighbours.
#include "chart/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace hogelscope {

namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();
constexpr double margin = 1.5;     // between a label and anything else
constexpr double besideGap = 6.0;  // up to this far from its marker a label needs no leader

// What a label pays, in points of distance from its marker.
constexpr double perLineCovered = 30;
constexpr double perLineFollowed = 60;
constexpr double perLeaderCrossed = 60;
constexpr double perObstacleCrossed = 60;
constexpr double perNeighbour = 12;  // another marker so close that it might be the one meant
constexpr double perOtherArea = 40;  // than the point's own

struct Candidate {
  LabelPlace place;
  double price = 0;  ///< whatever the other labels do
};

/// Liang and Barsky's clipping: is any of the line inside?
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

QPointF nearest(const QRectF& box, const QPointF& to) {
  return {std::clamp(to.x(), box.left(), box.right()), std::clamp(to.y(), box.top(), box.bottom())};
}

QRectF grown(const QRectF& box, double by) {
  return box.adjusted(-by, -by, by, by);
}

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
  QLineF leader(request.point, nearest(box, request.point));
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
class Candidates {
 public:
  Candidates(const LabelRequest& request, const LabelSurroundings& around)
      : m_request(request), m_around(around) {}

  std::vector<Candidate> near() {
    constexpr std::array gaps{0.0, 2.5, 7.0, 12.0, 18.0,  25.0,  33.0, 42.0,
                              52., 66., 82., 100., 125.0, 155.0, 190.0};
    constexpr int directions = 16;
    for (const double gap : gaps)
      for (int k = 0; k < directions; ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        const QPointF direction(std::cos(angle), -std::sin(angle));
        // To the right is where readers look first; steep leaders are easier to follow than flat.
        const double taste = 1.5 * (1 - direction.x()) + 0.15 * gap * std::abs(direction.x());
        take(beside(m_request, m_request.gap + gap, direction), gap + taste);
      }
    return sorted();
  }

  /// The last resort: all over the areas.
  std::vector<Candidate> anywhere() {
    for (const QRectF& area : m_around.areas)
      for (double y = area.top() + margin; y < area.bottom(); y += 4)
        for (double x = area.left() + margin; x < area.right(); x += 8) {
          const QRectF box({x, y}, m_request.size);
          take(box, QLineF(m_request.point, nearest(box, m_request.point)).length());
        }
    return sorted();
  }

 private:
  void take(const QRectF& box, double distance) {
    const QRectF wide = grown(box, margin);
    const auto holds = [&](const QRectF& area) { return area.contains(wide); };
    const auto area = std::find_if(m_around.areas.begin(), m_around.areas.end(), holds);
    const auto covers = [&](const QRectF& obstacle) { return wide.intersects(obstacle); };
    if (area == m_around.areas.end() ||
        std::any_of(m_around.obstacles.begin(), m_around.obstacles.end(), covers))
      return;
    const LabelPlace place = placeAt(m_request, box);
    const double abroad = area->contains(m_request.point) ? 0 : perOtherArea;
    m_all.push_back({place, distance + abroad + priceOf(place)});
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

  std::vector<Candidate> sorted() {
    std::stable_sort(m_all.begin(), m_all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.price < b.price; });
    return std::move(m_all);
  }

  const LabelRequest& m_request;
  const LabelSurroundings& m_around;
  std::vector<Candidate> m_all;
};

class Placer {
 public:
  Placer(const std::vector<LabelRequest>& requests, const LabelSurroundings& around)
      : m_requests(requests), m_around(around), m_chosen(requests.size()) {
    for (const LabelRequest& request : requests)
      m_near.push_back(Candidates(request, around).near());
    m_anywhere.resize(requests.size());
  }

  std::vector<std::optional<LabelPlace>> run() {
    if (placeAll()) {
      constexpr int rounds = 3;
      for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < m_chosen.size(); ++k) improve(k);
    }
    std::vector<std::optional<LabelPlace>> places;
    for (const auto& chosen : m_chosen)
      places.push_back(chosen ? std::optional(chosen->place) : std::nullopt);
    return places;
  }

 private:
  using Chosen = std::vector<std::optional<Candidate>>;

  /// Who finds no room chooses first in the next attempt.
  bool placeAll() {
    std::vector<std::size_t> order(m_requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    constexpr int attempts = 8;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      std::fill(m_chosen.begin(), m_chosen.end(), std::nullopt);
      for (const std::size_t k : order) m_chosen[k] = best(k);
      const auto failed = std::find_if(order.begin(), order.end(),
                                       [&](std::size_t k) { return !m_chosen[k].has_value(); });
      if (failed == order.end()) return true;
      std::rotate(order.begin(), failed, failed + 1);
    }
    return false;
  }

  /// The label chooses before its neighbours, if all of them together gain by it.
  void improve(std::size_t k) {
    constexpr double goodEnough = 6;
    if (m_chosen[k]->price + crossings(m_chosen[k]->place, k) < goodEnough) return;
    const Chosen before = m_chosen;
    const double price = total();
    std::vector<std::size_t> freed = neighbours(k);
    for (const std::size_t other : freed) m_chosen[other].reset();
    for (const std::size_t other : freed) m_chosen[other] = best(other);
    if (!(total() < price)) m_chosen = before;
  }

  /// The label and those that stand nearest to its point.
  std::vector<std::size_t> neighbours(std::size_t k) const {
    constexpr std::size_t most = 7;
    const QPointF point = m_requests[k].point;
    const auto distance = [&](std::size_t other) {
      if (other == k) return -1.0;
      return QLineF(point, nearest(m_chosen[other]->place.box, point)).length();
    };
    std::vector<std::size_t> all(m_requests.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::stable_sort(all.begin(), all.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    all.resize(std::min(all.size(), most));
    return all;
  }

  double total() const {
    double sum = 0;
    for (std::size_t k = 0; k < m_chosen.size(); ++k)
      sum += m_chosen[k] ? m_chosen[k]->price + crossings(m_chosen[k]->place, k) / 2 : impossible;
    return sum;
  }

  std::optional<Candidate> best(std::size_t k) {
    if (const auto candidate = cheapest(k, m_near[k])) return candidate;
    if (!m_anywhere[k]) m_anywhere[k] = Candidates(m_requests[k], m_around).anywhere();
    return cheapest(k, *m_anywhere[k]);
  }

  std::optional<Candidate> cheapest(std::size_t k, const std::vector<Candidate>& candidates) const {
    const Candidate* found = nullptr;
    double least = impossible;
    for (const Candidate& candidate : candidates) {
      if (candidate.price >= least) break;  // so are all that follow
      const double price = candidate.price + crossings(candidate.place, k);
      if (price >= least) continue;
      least = price;
      found = &candidate;
    }
    return found == nullptr ? std::nullopt : std::optional(*found);
  }

  /// What the other labels make label `k` pay at this place.
  double crossings(const LabelPlace& place, std::size_t k) const {
    const QRectF wide = grown(place.box, margin);
    double price = 0;
    for (std::size_t other = 0; other < m_chosen.size() && price < impossible; ++other) {
      if (other == k || !m_chosen[other]) continue;
      const LabelPlace& there = m_chosen[other]->place;
      const bool isCovered = wide.intersects(there.box) ||
                             (place.leader && meets(*place.leader, grown(there.box, 1))) ||
                             (there.leader && meets(*there.leader, grown(place.box, 1)));
      if (isCovered) return impossible;
      if (place.leader && there.leader &&
          place.leader->intersects(*there.leader) == QLineF::BoundedIntersection)
        price += perLeaderCrossed;
    }
    return price;
  }

  const std::vector<LabelRequest>& m_requests;
  const LabelSurroundings& m_around;
  std::vector<std::vector<Candidate>> m_near;
  std::vector<std::optional<std::vector<Candidate>>> m_anywhere;
  Chosen m_chosen;
};

}  // namespace

std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<LabelRequest>& requests,
                                                   const LabelSurroundings& surroundings) {
  return Placer(requests, surroundings).run();
}

}  // namespace hogelscope
