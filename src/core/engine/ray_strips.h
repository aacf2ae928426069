// SPDX-License-Identifier: BSD-3-Clause
// The loops of row_kernels.cpp, lens_kernels.cpp and twin_kernels.cpp share this: rays in strips,
// their indices and texels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>

#include "core/engine/hit_map.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// The numbers of a HitMap in the precision of the arithmetic.
template <class Real>
struct RealMap {
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

/// The real-valued indices at which the ray through (x, y, 1) meets the display.
template <class Real>
struct RealHit {
  Real i;
  Real j;
  Real u;
  Real v;
  bool isToward;
};

template <class Real>
inline RealHit<Real> hitOf(const RealMap<Real>& m, Real x, Real y) {
  const RealSlopes<Real> s = slopesOf(m, x, y);
  return {m.constant[0] + m.slope[0] * s.a, m.constant[1] + m.slope[1] * s.b,
          m.constant[2] + m.slope[2] * s.a, m.constant[3] + m.slope[3] * s.b, s.isToward};
}

/// Whether all indices are in range. It is bitwise on purpose, without branches. Returns false for
/// NaN.
template <class Real>
inline bool isSeen(const RealMap<Real>& m, const RealHit<Real>& h) {
  return static_cast<bool>(h.isToward & (h.i >= 0) & (h.i < m.count[0]) & (h.j >= 0) &
                           (h.j < m.count[1]) & (h.u >= 0) & (h.u < m.count[2]) & (h.v >= 0) &
                           (h.v < m.count[3]));
}

template <class Real>
inline std::uint32_t cellOf(Real index) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(index));
}

/// Writes three bytes for each address.
inline void packRgb(const Texel<std::uint8_t>* texels, const std::uint32_t* address, int count,
                    std::uint8_t* rgb) {
  // Whole texels are copied, each over the previous one's unused byte; the last has no room for its
  // own.
#pragma GCC unroll 8
  for (int k = 0; k + 1 < count; ++k)
    std::memcpy(rgb + std::ptrdiff_t(3) * k, texels + address[k], 4);
  if (count > 0) std::memcpy(rgb + std::ptrdiff_t(3) * (count - 1), texels + address[count - 1], 3);
}

/// The number of rays in a strip: so few that a processor works on one strip while the next one's
/// texels come from memory, and so many that their steps fill its units.
constexpr int stripSize = 64;
template <class T>
using Strip = std::array<T, stripSize>;

/// The cells of a strip; all bits of `seen` are set where the ray sees the display, none elsewhere.
struct CellStrip {
  std::array<Strip<std::uint32_t>, 4> cell;
  Strip<std::uint32_t> seen;
};

/// Any rays, or those of a row, which have one y; `hits` are a row's that are known to hit.
enum class Rays { any, row, hits };

/// Fewer rays than a strip are copied, the first one filling what is left, and x and y then point
/// to the copies.
template <Rays rays>
inline __attribute__((always_inline)) void padStrip(const double*& x, const double*& y, int count,
                                                    Strip<double>& paddedX,
                                                    Strip<double>& paddedY) {
  if (count == stripSize) return;
  paddedX.fill(x[0]);
  paddedY.fill(y[0]);
  std::copy_n(x, count, paddedX.begin());
  if constexpr (rays == Rays::any) std::copy_n(y, count, paddedY.begin());
  x = paddedX.data();
  y = paddedY.data();
}

/// The rays of a strip that see the display.
enum class StripHits { none, some, all };

/// The addresses of a strip's texels; `seen` is as in a CellStrip.
struct AddressStrip {
  Strip<std::uint32_t> address;
  Strip<std::uint32_t> seen;
};

inline __attribute__((always_inline)) void findAddresses(const BlockLayout& l,
                                                         const CellStrip& cells,
                                                         AddressStrip& strip) {
  for (std::size_t k = 0; k < stripSize; ++k)
    strip.address[k] = l.i.inBlocks(cells.cell[0][k]) + l.j.inBlocks(cells.cell[1][k]) +
                       l.u.inBlocks(cells.cell[2][k]) + l.v.inBlocks(cells.cell[3][k]);
  strip.seen = cells.seen;
}

/// Rays of one row of an image, and where their texels go.
struct RayRow {
  const double* x;  ///< of their points on the plane z = 1
  const double* y;  ///< one value if the row's rays have one y
  int count;
  std::uint8_t* rgb;   ///< three bytes a ray
  std::uint8_t* seen;  ///< null if all rays are known to hit
};

/// Prefetches the texels of the first `count` rays into the second cache, which is faster than into
/// the first one (docs/measurements.md, Views), and writes which of them are seen.
inline __attribute__((always_inline)) void fetchStrip(const BlockLayout& l,
                                                      const Texel<std::uint8_t>* texels,
                                                      StripHits hits, int count,
                                                      AddressStrip& strip, std::uint8_t* seen) {
  if (hits == StripHits::some)
    for (std::size_t k = 0; k < stripSize; ++k)
      strip.address[k] = strip.seen[k] != 0 ? strip.address[k] : l.texels;
#pragma GCC unroll 8
  for (int k = 0; k < count; ++k) __builtin_prefetch(texels + strip.address[k], 0, 2);
  if (seen == nullptr) return;
  if (hits == StripHits::all)
    std::memset(seen, 255, std::size_t(count));
  else
    for (int k = 0; k < count; ++k) seen[k] = static_cast<std::uint8_t>(strip.seen[std::size_t(k)]);
}

/// Copies a texel for each ray; find(row, first, count, strip) finds the addresses of a row's rays
/// from `first` on, at most a strip, three strips before they are copied, so that texels have come
/// from memory; rows follow each other without a gap. Strips of which no ray hits are black.
template <class Find, class Row>
inline __attribute__((always_inline)) void copyStrips(const Find& find, const BlockLayout& layout,
                                                      const Texel<std::uint8_t>* texels,
                                                      std::span<const Row> rows) {
  constexpr std::size_t ahead = 3;
  constexpr std::size_t kept = 4;
  struct Waiting {
    AddressStrip strip;
    std::uint8_t* rgb;
    int count;
  };
  const BlockLayout l = layout;  // a copy, so that the compiler knows that stores do not change it
  std::array<Waiting, kept> waiting;
  std::size_t found = 0;
  const auto copy = [&](std::size_t strip) __attribute__((always_inline)) {
    const Waiting& w = waiting[strip % kept];
    packRgb(texels, w.strip.address.data(), w.count, w.rgb);
  };
  for (const Row& row : rows)
    for (int first = 0; first < row.count; first += stripSize) {
      Waiting& w = waiting[found % kept];
      w.rgb = row.rgb + std::ptrdiff_t(3) * first;
      w.count = std::min(stripSize, row.count - first);
      std::uint8_t* const seen = row.seen == nullptr ? nullptr : row.seen + first;
      const StripHits hits = find(row, first, w.count, w.strip);
      if (hits == StripHits::none) {
        std::memset(w.rgb, 0, std::size_t(3 * w.count));
        if (seen != nullptr) std::memset(seen, 0, std::size_t(w.count));
        continue;
      }
      fetchStrip(l, texels, hits, w.count, w.strip, seen);
      if (found >= ahead) copy(found - ahead);
      ++found;
    }
  for (std::size_t strip = found > ahead ? found - ahead : 0; strip < found; ++strip) copy(strip);
}

/// The same for rays through points (x, y), whose cells find(x, y, strip) finds.
template <Rays rays, class Find>
inline __attribute__((always_inline)) void copyTexels(const Find& find, const BlockLayout& layout,
                                                      const Texel<std::uint8_t>* texels,
                                                      std::span<const RayRow> rows) {
  const BlockLayout l = layout;
  const auto findPadded = [&find, l ](const RayRow& row, int first, int many, AddressStrip& strip)
      __attribute__((always_inline)) {
    Strip<double> paddedX;
    Strip<double> paddedY;
    const double* stripX = row.x + first;
    const double* stripY = rays == Rays::any ? row.y + first : row.y;
    padStrip<rays>(stripX, stripY, many, paddedX, paddedY);
    CellStrip cells;
    find(stripX, stripY, cells);
    findAddresses(l, cells, strip);
    return rays == Rays::hits ? StripHits::all : StripHits::some;
  };
  copyStrips(findPadded, layout, texels, rows);
}

/// The indices of a batch; 0 where nothing is seen.
template <class Real>
struct IndexBatch {
  std::array<std::array<Real, batchSize>, 4> index;
  std::array<std::uint32_t, batchSize> seen;
};

template <class Real>
inline void keep(const RealMap<Real>& m, const RealHit<Real>& h, std::size_t k,
                 IndexBatch<Real>& batch) {
  const bool seen = isSeen(m, h);
  batch.index[0][k] = seen ? h.i : 0;
  batch.index[1][k] = seen ? h.j : 0;
  batch.index[2][k] = seen ? h.u : 0;
  batch.index[3][k] = seen ? h.v : 0;
  batch.seen[k] = seen ? 255 : 0;
}

template <class Real>
inline __attribute__((always_inline)) void split(const IndexBatch<Real>& from, int count,
                                                 CellBatch& batch) {
  const auto rays = std::size_t(count);
  for (std::size_t axis = 0; axis < 4; ++axis)
    for (std::size_t k = 0; k < rays; ++k) {
      const Real index = from.index[axis][k];
      const auto cell = static_cast<std::int32_t>(index);
      batch.cell[axis][k] = static_cast<std::uint32_t>(cell);
      batch.place[axis][k] = static_cast<float>(index - static_cast<Real>(cell));
    }
  for (std::size_t k = 0; k < rays; ++k) batch.seen[k] = static_cast<std::uint8_t>(from.seen[k]);
}

}  // namespace hogelscope
