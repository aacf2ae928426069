// SPDX-License-Identifier: BSD-3-Clause
// Finders say which cells rays meet; the loops over rays stand here once for all. A finder has
//
//     Number      the arithmetic's precision
//     colours     1, or 3 if red, green and blue of a ray meet texels of their own
//     rowHits     the rays of a row that are known to hit: none, some (RayRow::hits), all
//     count       the cells of each axis
//     hit(x, y)   the indices at which the ray through (x, y, 1) meets the display
//
// and, where a strip takes less time than its rays one by one, an overload of findStrip() or
// findAddresses(). The compiler vectorises these plain loops.
#pragma once

#include "core/engine/hit_map.h"
#include "core/engine/ray_strips.h"

namespace hogelscope {

/// The numbers of a HitMap in the precision of the arithmetic.
template <class Real>
struct RealMap {
  using Number = Real;
  static constexpr std::size_t colours = 1;
  static constexpr StripHits rowHits = StripHits::none;

  explicit RealMap(const HitMap& m) {
    for (std::size_t c = 0; c < 3; ++c) {
      right[c] = static_cast<Real>(m.right[c]);
      down[c] = static_cast<Real>(m.down[c]);
      forward[c] = static_cast<Real>(m.forward[c]);
    }
    for (std::size_t axis = 0; axis < 4; ++axis) {
      constant[axis] = static_cast<Real>(m.panel.constant[axis]);
      slope[axis] = static_cast<Real>(m.panel.slope[axis]);
      count[axis] = static_cast<Real>(m.panel.count[axis]);
    }
  }

  std::array<Real, 3> right, down, forward;
  std::array<Real, 4> constant, slope, count;
};

/// The slopes of the ray through (x, y, 1), and whether it points to the panel.
template <class Real>
struct RealSlopes {
  Real a;
  Real b;
  bool isToward;
};

template <class Real>
inline RealSlopes<Real> slopesOf(const RealMap<Real>& m, Real x, Real y) {
  const Real dx = m.right[0] * x + m.down[0] * y + m.forward[0];
  const Real dy = m.right[1] * x + m.down[1] * y + m.forward[1];
  const Real dz = m.right[2] * x + m.down[2] * y + m.forward[2];
  const Real inverse = 1 / dz;
  return {dx * inverse, dy * inverse, dz < 0};
}

/// The real-valued indices at which a ray meets the display, of no use if the panel is not met.
template <class Real>
struct RealHit {
  Real i;
  Real j;
  Real u;
  Real v;
  bool isMet;
};

/// Whether all indices are in range. It is bitwise on purpose, without branches. Returns false for
/// NaN.
template <class Finder, class Real>
inline bool isSeen(const Finder& m, const RealHit<Real>& h) {
  return static_cast<bool>(h.isMet & (h.i >= 0) & (h.i < m.count[0]) & (h.j >= 0) &
                           (h.j < m.count[1]) & (h.u >= 0) & (h.u < m.count[2]) & (h.v >= 0) &
                           (h.v < m.count[3]));
}

template <class Real>
inline std::uint32_t cellOf(Real index) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(index));
}

/// The cells of a strip; `seen` is as in an AddressStrip.
struct CellStrip {
  std::array<Strip<std::uint32_t>, 4> cell;
  Strip<std::uint32_t> seen;
};

/// Finds the cells of a strip. A coordinate of a ray known
/// to hit that rounding has put on a border belongs to the last cell. The indices have a loop, and
/// the cells of each axis have one: a processor overlaps the iterations of short loops better than
/// those of one long loop.
template <Rays rays, class Finder>
inline __attribute__((always_inline)) void findStrip(const Finder& finder, const double* x,
                                                     const double* y, CellStrip& strip) {
  std::array<Strip<typename Finder::Number>, 4> index;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const auto h = finder.hit(x[k], y[rays == Rays::any ? k : 0]);
    const bool seen = rays == Rays::hits || isSeen(finder, h);
    index[0][k] = seen ? h.i : 0;
    index[1][k] = seen ? h.j : 0;
    index[2][k] = seen ? h.u : 0;
    index[3][k] = seen ? h.v : 0;
    strip.seen[k] = seen ? ~0U : 0;
  }
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto last = static_cast<std::uint32_t>(finder.count[axis]) - 1;
    for (std::size_t k = 0; k < stripSize; ++k) {
      const std::uint32_t cell = cellOf(index[axis][k]);
      strip.cell[axis][k] = rays == Rays::hits ? std::min(cell, last) : cell;
    }
  }
}

/// Finds the addresses of a strip.
template <Rays rays, class Finder>
inline __attribute__((always_inline)) void findAddresses(const Finder& finder, const BlockLayout& l,
                                                         const double* x, const double* y,
                                                         AddressStrip<1>& strip) {
  CellStrip cells;
  findStrip<rays>(finder, x, y, cells);
  for (std::size_t k = 0; k < stripSize; ++k)
    strip.address[0][k] = l.i.inBlocks(cells.cell[0][k]) + l.j.inBlocks(cells.cell[1][k]) +
                          l.u.inBlocks(cells.cell[2][k]) + l.v.inBlocks(cells.cell[3][k]);
  strip.seen = cells.seen;
}

/// Copies the light of rays. Where there are fewer than a strip, the first one fills what is left.
template <Rays rays, class Finder>
inline __attribute__((always_inline)) void copyRows(const Finder& finder, const BlockLayout& layout,
                                                    const Texel<std::uint8_t>* texels,
                                                    std::span<const RayRow> rows) {
  constexpr std::size_t colours = Finder::colours;
  const BlockLayout l = layout;
  const auto find = [&finder, l ](const RayRow& row, int first, int many,
                                  AddressStrip<colours>& strip) __attribute__((always_inline)) {
    Strip<double> paddedX;
    Strip<double> paddedY;
    const double* x = row.x + first;
    const double* y = rays == Rays::any ? row.y + first : row.y;
    if (many < stripSize) {
      paddedX.fill(x[0]);
      paddedY.fill(y[0]);
      std::copy_n(x, many, paddedX.begin());
      if constexpr (rays == Rays::any) std::copy_n(y, many, paddedY.begin());
      x = paddedX.data();
      y = paddedY.data();
    }
    if constexpr (rays == Rays::row && Finder::rowHits != StripHits::none)
      if (Finder::rowHits == StripHits::all ||
          (first >= row.hits[0] && first + many <= row.hits[1])) {
        findAddresses<Rays::hits>(finder, l, x, y, strip);
        return StripHits::all;
      }
    findAddresses<rays>(finder, l, x, y, strip);
    return StripHits::some;
  };
  copyStrips<colours>(find, layout, texels, rows);
}

/// Finds the cells of a batch; cell 0 where nothing is seen.
template <class Finder>
inline __attribute__((always_inline)) void cellsOf(const Finder& finder, const double* x,
                                                   const double* y, int count, CellBatch& batch) {
  using Real = typename Finder::Number;
  std::array<std::array<Real, batchSize>, 4> index;
  std::array<std::uint32_t, batchSize> seen;
  const auto rays = std::size_t(count);
  for (std::size_t k = 0; k < rays; ++k) {
    const RealHit<Real> h = finder.hit(x[k], y[k]);
    const bool sees = isSeen(finder, h);
    index[0][k] = sees ? h.i : 0;
    index[1][k] = sees ? h.j : 0;
    index[2][k] = sees ? h.u : 0;
    index[3][k] = sees ? h.v : 0;
    seen[k] = sees ? 255 : 0;
  }
  for (std::size_t axis = 0; axis < 4; ++axis)
    for (std::size_t k = 0; k < rays; ++k) {
      const auto cell = static_cast<std::int32_t>(index[axis][k]);
      batch.cell[axis][k] = static_cast<std::uint32_t>(cell);
      batch.place[axis][k] = static_cast<float>(index[axis][k] - static_cast<Real>(cell));
    }
  for (std::size_t k = 0; k < rays; ++k) batch.seen[k] = static_cast<std::uint8_t>(seen[k]);
}

}  // namespace hogelscope
