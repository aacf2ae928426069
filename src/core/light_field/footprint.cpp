// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/footprint.h"

#include <numeric>

namespace hogelscope {

namespace {

std::size_t total(const std::vector<CellRange>& ranges) {
  return std::accumulate(
      ranges.begin(), ranges.end(), std::size_t{0},
      [](std::size_t sum, const CellRange& range) { return sum + range.size(); });
}

bool coversAll(const std::vector<CellRange>& a, const std::vector<CellRange>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const CellRange& x, const CellRange& y) { return x.covers(y); });
}

}  // namespace

std::size_t Footprint::texels() const {
  return total(u) * total(v);
}

bool Footprint::covers(const Footprint& other) const {
  return coversAll(u, other.u) && coversAll(v, other.v);
}

void Footprint::include(const Footprint& other) {
  for (std::size_t i = 0; i < u.size(); ++i) u[i].include(other.u[i]);
  for (std::size_t j = 0; j < v.size(); ++j) v[j].include(other.v[j]);
}

}  // namespace hogelscope
