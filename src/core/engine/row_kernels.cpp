// SPDX-License-Identifier: BSD-3-Clause
// The loops that the time goes into, compiled once for each kind of machine.
#include "core/engine/row_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/multiversioned.h"
#include "core/optics/psf.h"

namespace hogelscope {

namespace {

/// A texel of 8-bit values as one word, red in the lowest byte.
#if defined(__GNUC__)
using Word = std::uint32_t __attribute__((may_alias));
#else
using Word = std::uint32_t;
#endif

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
      constant[axis] = static_cast<Real>(m.constant[axis]);
      slope[axis] = static_cast<Real>(m.slope[axis]);
      count[axis] = static_cast<Real>(m.count[axis]);
    }
  }

  std::array<Real, 3> right, down, forward;
  std::array<Real, 4> constant, slope, count;
};

/// Returns the real-valued indices where the ray through (x, y, 1) meets the display.
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
  const Real dx = m.right[0] * x + m.down[0] * y + m.forward[0];
  const Real dy = m.right[1] * x + m.down[1] * y + m.forward[1];
  const Real dz = m.right[2] * x + m.down[2] * y + m.forward[2];
  const Real inverse = 1 / dz;
  const Real a = dx * inverse;
  const Real b = dy * inverse;
  return {m.constant[0] + m.slope[0] * a, m.constant[1] + m.slope[1] * b,
          m.constant[2] + m.slope[2] * a, m.constant[3] + m.slope[3] * b, dz < 0};
}

/// Whether all indices are in range. Bitwise on purpose: no branches. False for NaN.
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

/// Returns the cell of a coordinate; one that rounding has put beyond a border is in the last cell.
template <class Real>
inline std::uint32_t cellWithin(Real index, Real count) {
  const Real last = count - 1;
  const Real positive = index > 0 ? index : 0;
  return cellOf(positive < last ? positive : last);
}

template <class Real>
inline __attribute__((always_inline)) void addressesOfHitsIn(const HitMap& map,
                                                             const BlockLayout& layout,
                                                             const double* x, double y, int count,
                                                             std::uint32_t* address) {
  const RealMap<Real> m(map);  // a copy, so that the compiler knows that stores do not change it
  const BlockLayout l = layout;
  for (int k = 0; k < count; ++k) {
    const RealHit<Real> h = hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y));
    address[k] =
        l.i.inBlocks(cellWithin(h.i, m.count[0])) + l.j.inBlocks(cellWithin(h.j, m.count[1])) +
        l.u.inBlocks(cellWithin(h.u, m.count[2])) + l.v.inBlocks(cellWithin(h.v, m.count[3]));
  }
}

template <class Real>
inline __attribute__((always_inline)) void addressesIn(const HitMap& map, const BlockLayout& layout,
                                                       const double* x, const double* y, int count,
                                                       std::uint32_t unseen,
                                                       std::uint32_t* address) {
  const RealMap<Real> m(map);
  const BlockLayout l = layout;
  for (int k = 0; k < count; ++k) {
    const RealHit<Real> h = hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k]));
    const bool seen = isSeen(m, h);
    const std::uint32_t found =
        l.i.inBlocks(cellOf(seen ? h.i : 0)) + l.j.inBlocks(cellOf(seen ? h.j : 0)) +
        l.u.inBlocks(cellOf(seen ? h.u : 0)) + l.v.inBlocks(cellOf(seen ? h.v : 0));
    address[k] = seen ? found : unseen;
  }
}

template <class Real>
inline void keep(const RealMap<Real>& m, const RealHit<Real>& h, int k, CellBatch& batch) {
  const bool seen = isSeen(m, h);
  const std::array<Real, 4> index{seen ? h.i : 0, seen ? h.j : 0, seen ? h.u : 0, seen ? h.v : 0};
  const auto at = std::size_t(k);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::uint32_t cell = cellOf(index[axis]);
    batch.cell[axis][at] = cell;
    batch.place[axis][at] =
        static_cast<float>(index[axis] - static_cast<Real>(static_cast<std::int32_t>(cell)));
  }
  batch.seen[at] = seen ? 255 : 0;
}

template <class Real>
inline __attribute__((always_inline)) void cellsIn(const HitMap& map, const double* x,
                                                   const double* y, int count, CellBatch& batch) {
  const RealMap<Real> m(map);
  for (int k = 0; k < count; ++k)
    keep(m, hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k])), k, batch);
}

}  // namespace

MULTIVERSIONED
void addressesOfHits(const HitMap& map, const BlockLayout& layout, const double* x, double y,
                     int count, std::uint32_t* address) {
  if (map.isSingle)
    addressesOfHitsIn<float>(map, layout, x, y, count, address);
  else
    addressesOfHitsIn<double>(map, layout, x, y, count, address);
}

MULTIVERSIONED
void addresses(const HitMap& map, const BlockLayout& layout, const double* x, const double* y,
               int count, std::uint32_t unseen, std::uint32_t* address) {
  if (map.isSingle)
    addressesIn<float>(map, layout, x, y, count, unseen, address);
  else
    addressesIn<double>(map, layout, x, y, count, unseen, address);
}

MULTIVERSIONED
void linearCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch) {
  if (map.isSingle)
    cellsIn<float>(map, x, y, count, batch);
  else
    cellsIn<double>(map, x, y, count, batch);
}

namespace {

template <class Real>
void curvedCellsIn(const HitMap& map, const HogelLens& across, const HogelLens& down,
                   const double* x, const double* y, int count, CellBatch& batch) {
  const RealMap<Real> m(map);
  const auto directionOf = [](const HogelLens& lens, Real slope) {
    return static_cast<Real>(lens.directionOf(static_cast<double>(slope)));
  };
  constexpr auto half = static_cast<Real>(0.5);
  for (int k = 0; k < count; ++k) {
    RealHit<Real> h = hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k]));
    h.u = m.count[2] * (half + directionOf(across, h.u));
    h.v = m.count[3] * (half - directionOf(down, h.v));
    keep(m, h, k, batch);
  }
}

}  // namespace

void curvedCells(const HitMap& map, const HogelLens& across, const HogelLens& down, const double* x,
                 const double* y, int count, CellBatch& batch) {
  if (map.isSingle)
    curvedCellsIn<float>(map, across, down, x, y, count, batch);
  else
    curvedCellsIn<double>(map, across, down, x, y, count, batch);
}

MULTIVERSIONED
void bracketingCells(const AxisLayout& layout, int cells, const std::uint32_t* cell,
                     const float* place, std::uint32_t* offset, float* weight) {
  const AxisLayout l = layout;
  for (int k = 0; k < batchSize; ++k) {
    const int before = place[k] < 0.5F ? 1 : 0;
    const int left = static_cast<int>(cell[k]) - before;
    const float share = place[k] - 0.5F + static_cast<float>(before);
    offset[k] = l(static_cast<std::uint32_t>(std::max(left, 0)));
    offset[batchSize + k] = l(static_cast<std::uint32_t>(std::min(left + 1, cells - 1)));
    weight[k] = 1 - share;
    weight[batchSize + k] = share;
  }
}

MULTIVERSIONED
void gather(const Texel<std::uint8_t>* texels, const std::uint32_t* address, int count,
            Texel<std::uint8_t>* out) {
  const auto* from = reinterpret_cast<const Word*>(texels);
  auto* to = reinterpret_cast<Word*>(out);
  for (int k = 0; k < count; ++k) to[k] = from[address[k]];
}

void packRgb(const Texel<std::uint8_t>* texels, int count, std::uint8_t* rgb) {
  // Whole texels, each over the last one's unused byte; the last has no room for its own.
  for (int k = 0; k + 1 < count; ++k) std::memcpy(rgb + std::ptrdiff_t(3) * k, texels + k, 4);
  if (count > 0) std::memcpy(rgb + std::ptrdiff_t(3) * (count - 1), texels + count - 1, 3);
}

MULTIVERSIONED
void maskSeen(const std::uint32_t* address, int count, std::uint32_t unseen, std::uint8_t* seen) {
  for (int k = 0; k < count; ++k) seen[k] = address[k] == unseen ? 0 : 255;
}

namespace {

/// Returns r, g, b of a stored texel as code values.
struct Light {
  float r;
  float g;
  float b;
};

inline Light encodedLight(const Texel<std::uint8_t>* texels, std::uint32_t at) {
  const std::uint32_t word = reinterpret_cast<const Word*>(texels)[at];
  return {static_cast<float>(std::int32_t(word & 255U)),
          static_cast<float>(std::int32_t(word >> 8U & 255U)),
          static_cast<float>(std::int32_t(word >> 16U & 255U))};
}

inline Light encodedLight(const Texel<std::uint16_t>* texels, std::uint32_t at) {
  constexpr float scale = 1 / 257.0F;
  const Texel<std::uint16_t>& t = texels[at];
  return {scale * t.r, scale * t.g, scale * t.b};
}

inline Light encodedLight(const Texel<float>* texels, std::uint32_t at) {
  const Texel<float>& t = texels[at];
  return {255 * t.r, 255 * t.g, 255 * t.b};
}

/// Loops over the rays for each tap; `light(at)` is the light of texel `at`.
template <class LightAt>
inline __attribute__((always_inline)) void sumTaps(const TapBatch& taps, int count, LightBatch& sum,
                                                   LightAt light) {
  const std::uint32_t* base = taps.base;
  float* r = sum.r.data();
  float* g = sum.g.data();
  float* b = sum.b.data();
  for (int t = 0; t < taps.taps; ++t) {
    const std::uint32_t* offset = taps.offset[t].data();
    const auto add = [&](int k, float weight) {
      const Light c = light(base[k] + offset[k]);
      r[k] += weight * c.r;
      g[k] += weight * c.g;
      b[k] += weight * c.b;
    };
    if (taps.share != nullptr && taps.scale == nullptr) {
      const float share = taps.share[t];
#pragma GCC ivdep
      for (int k = 0; k < count; ++k) add(k, share);
    } else if (taps.share != nullptr) {
      const float share = taps.share[t];
      const float* scale = taps.scale;
#pragma GCC ivdep
      for (int k = 0; k < count; ++k) add(k, share * scale[k]);
    } else {
      const float* weight = taps.weight[t].data();
      const float* scale = taps.scale;
#pragma GCC ivdep
      for (int k = 0; k < count; ++k) add(k, weight[k] * scale[k]);
    }
  }
}

}  // namespace

MULTIVERSIONED
void accumulate(const Texel<std::uint8_t>* texels, const TapBatch& taps, int count,
                LightBatch& sum) {
  sumTaps(taps, count, sum, [texels](std::uint32_t at) { return encodedLight(texels, at); });
}

MULTIVERSIONED
void accumulate(const Texel<std::uint16_t>* texels, const TapBatch& taps, int count,
                LightBatch& sum) {
  sumTaps(taps, count, sum, [texels](std::uint32_t at) { return encodedLight(texels, at); });
}

MULTIVERSIONED
void accumulate(const Texel<float>* texels, const TapBatch& taps, int count, LightBatch& sum) {
  sumTaps(taps, count, sum, [texels](std::uint32_t at) { return encodedLight(texels, at); });
}

template <class T>
void accumulateLinear(const Texel<T>* texels, const TapBatch& taps, int count, LightBatch& sum) {
  sumTaps(taps, count, sum, [texels](std::uint32_t at) {
    const Light c = encodedLight(texels, at);
    return Light{static_cast<float>(linearFromEncoded(c.r)),
                 static_cast<float>(linearFromEncoded(c.g)),
                 static_cast<float>(linearFromEncoded(c.b))};
  });
}

template void accumulateLinear(const Texel<std::uint8_t>*, const TapBatch&, int, LightBatch&);
template void accumulateLinear(const Texel<std::uint16_t>*, const TapBatch&, int, LightBatch&);
template void accumulateLinear(const Texel<float>*, const TapBatch&, int, LightBatch&);

}  // namespace hogelscope
