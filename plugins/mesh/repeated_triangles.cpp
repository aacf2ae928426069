// SPDX-License-Identifier: BSD-3-Clause
#include "repeated_triangles.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace hogelscope::mesh {

namespace {

using Place = std::array<float, 3>;
using Places = std::array<Place, 3>;

Places placesOf(const Corners& corners, const std::vector<float>& points) {
  Places places{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = &points[std::size_t{3} * corners[k]];
    places[k] = {p[0] + 0.0F, p[1] + 0.0F, p[2] + 0.0F};  // −0 is 0
  }
  std::sort(places.begin(), places.end());
  return places;
}

std::uint64_t hashOf(const Places& places) {
  std::uint64_t hash = 0;
  for (const Place& place : places)
    for (const float x : place) {
      hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29U;
    }
  return hash;
}

}  // namespace

std::vector<Corners> withoutRepeated(const std::vector<Corners>& triangles,
                                     const std::vector<float>& points,
                                     std::vector<std::uint32_t>& materialOf) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k)
    order.emplace_back(hashOf(placesOf(triangles[k], points)), std::uint32_t(k));
  std::sort(order.begin(), order.end());
  std::vector<bool> isRepeated(triangles.size());
  for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
    if (order[k].first != order[first].first) {
      first = k;
    } else {
      isRepeated[order[k].second] = placesOf(triangles[order[k].second], points) ==
                                    placesOf(triangles[order[first].second], points);
    }
  }
  std::vector<Corners> kept;
  kept.reserve(triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (isRepeated[k]) continue;
    materialOf[kept.size()] = materialOf[k];
    kept.push_back(triangles[k]);
  }
  materialOf.resize(kept.size());
  return kept;
}

}  // namespace hogelscope::mesh
