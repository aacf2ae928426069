// SPDX-License-Identifier: BSD-3-Clause
// Labels take the cheapest free place in turn; then those that did badly choose before their
// neighbours.
#include "chart/labels.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "chart/label_candidates.h"

namespace hogelscope {

namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();
constexpr double perLeaderCrossed = 60;  // of another label, as a price

class Placer {
 public:
  Placer(const std::vector<LabelRequest>& requests, const LabelSurroundings& around)
      : m_requests(requests), m_around(around), m_chosen(requests.size()) {
    for (const LabelRequest& request : requests) m_near.push_back(candidatesNear(request, around));
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
  using Chosen = std::vector<std::optional<LabelCandidate>>;

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
    constexpr int orders = 6;
    for (int order = 0; order < orders; ++order) {
      for (const std::size_t other : freed) m_chosen[other].reset();
      for (const std::size_t other : freed) m_chosen[other] = best(other);
      if (total() < price) return;
      std::shuffle(freed.begin() + 1, freed.end(), m_random);
    }
    m_chosen = before;
  }

  /// The label and those that stand nearest to its point.
  std::vector<std::size_t> neighbours(std::size_t k) const {
    constexpr std::size_t most = 9;
    const QPointF point = m_requests[k].point;
    const auto distance = [&](std::size_t other) {
      if (other == k) return -1.0;
      return QLineF(point, nearestPoint(m_chosen[other]->place.box, point)).length();
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

  std::optional<LabelCandidate> best(std::size_t k) {
    if (const auto candidate = cheapest(k, m_near[k])) return candidate;
    if (!m_anywhere[k]) m_anywhere[k] = candidatesAnywhere(m_requests[k], m_around);
    return cheapest(k, *m_anywhere[k]);
  }

  std::optional<LabelCandidate> cheapest(std::size_t k,
                                         const std::vector<LabelCandidate>& candidates) const {
    const LabelCandidate* found = nullptr;
    double least = impossible;
    for (const LabelCandidate& candidate : candidates) {
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
    const QRectF wide = grown(place.box, labelMargin);
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
  std::vector<std::vector<LabelCandidate>> m_near;
  std::vector<std::optional<std::vector<LabelCandidate>>> m_anywhere;
  Chosen m_chosen;
  std::minstd_rand m_random;  ///< with its own seed: the same chart is painted the same way
};

}  // namespace

std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<LabelRequest>& requests,
                                                   const LabelSurroundings& surroundings) {
  return Placer(requests, surroundings).run();
}

}  // namespace hogelscope
