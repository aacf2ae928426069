// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/outline.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/panel/twin.h"

namespace hogelscope {

namespace {

/// Keeps the part where constant + slope·x ≥ 0.
void clip(double constant, double slope, RowPart& part) {
  if (slope > 0)
    part[0] = std::max(part[0], -constant / slope);
  else if (slope < 0)
    part[1] = std::min(part[1], -constant / slope);
  else if (constant < 0)
    part = {1, 0};
}

}  // namespace

Outline::Outline(const HitMap& map)
    : m_z(timesZ(map, 1, 0, 0)), m_knowsHits(map.finder != Finder::sheet) {
  if (map.finder == Finder::design) addDesign(map);
  if (map.finder == Finder::affine) addAffine(map);
  if (map.finder == Finder::sheet) addSheet(map);
}

void Outline::add(const PlaneFunction& timesZ, int count, double margin) {
  m_indices.push_back({timesZ, double(count), margin});
}

void Outline::addDesign(const HitMap& map) {
  const auto& [constant, slope, count, display, eye, affine] = map.panel;
  for (std::size_t axis = 0; axis < 4; axis += 2) {
    add(timesZ(map, constant[axis], slope[axis], 0), count[axis], 0);
    add(timesZ(map, constant[axis + 1], 0, slope[axis + 1]), count[axis + 1], 0);
  }
}

/// u and v also depend on the whole hogel, which is within half a hogel of i − 1/2, on its own move
/// and on the map of directions: their sums are a margin.
void Outline::addAffine(const HitMap& map) {
  constexpr double rounding = 1e-6;
  const Twin& twin = *map.panel.display->twin();
  const AffineHits& hits = map.panel.affine;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& own = hits.place[axis];
    const auto& other = hits.place[1 - axis];
    add(timesZ(map, own[0], own[1], own[2]), map.panel.count[axis], rounding);
    const auto& [constant, slope, along, across] = hits.direction[axis];
    std::array<double, 3> index{constant + along * (own[0] - 0.5) + across * (other[0] - 0.5),
                                along * own[1] + across * other[1],
                                along * own[2] + across * other[2]};
    index[1 + axis] += slope;
    add(timesZ(map, index[0], index[1], index[2]), map.panel.count[axis + 2],
        (std::abs(along) + std::abs(across)) / 2 + twin.largestMoves()[axis] +
            twin.directionTable().largest()[axis] + rounding);
  }
}

/// A ray ends at most one lens farther than it would through a real-valued lens, and nothing moves
/// an end back onto the panel from beside it.
void Outline::addSheet(const HitMap& map) {
  constexpr double beside = 2 * LensSheet::farthestUp;
  const SheetHits hits = map.panel.display->sheet()->hitsFrom(map.panel.eye);
  for (const auto& [f, ofLens, count] :
       {std::tuple(hits.right, hits.rightOfLens, map.panel.count[0]),
        std::tuple(hits.up, hits.upOfLens, map.panel.count[1])})
    add(timesZ(map, f[0] + ofLens * hits.lens[0], f[1] + ofLens * hits.lens[1],
               f[2] + ofLens * hits.lens[2]),
        count, beside + std::abs(ofLens));
}

/// Each condition is linear in x once it is multiplied by d.z.
RowPart Outline::partOf(double y, RowPart row, double side) const {
  const double z = m_z[1] * y + m_z[2];
  clip(-z, -m_z[0], row);
  for (const auto& [timesZ, count, margin] : m_indices) {
    const double index = timesZ[1] * y + timesZ[2];
    const double least = -side * margin;
    const double most = count + side * margin;
    clip(least * z - index, least * m_z[0] - timesZ[0], row);
    clip(index - most * z, timesZ[0] - most * m_z[0], row);
  }
  return row;
}

}  // namespace hogelscope
