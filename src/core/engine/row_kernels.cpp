// SPDX-License-Identifier: BSD-3-Clause
// The loops that take most of the time, compiled once for each kind of processor.
#include "core/engine/row_kernels.h"

#include <algorithm>

#include "core/base/multiversioned.h"
#include "core/engine/ray_strips.h"
#include "core/engine/sheet_kernels.h"
#include "core/engine/twin_kernels.h"

namespace hogelscope {

namespace {

/// Finds the cells of a strip. The indices have a loop, and the cells of
/// each axis have one: a processor overlaps the iterations of short loops better than those of one
/// long loop.
template <Rays rays, class Real>
inline __attribute__((always_inline)) void findStrip(const RealMap<Real>& m, const double* x,
                                                     const double* y, CellStrip& strip) {
  std::array<Strip<Real>, 4> index;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const RealHit<Real> h =
        hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[rays == Rays::any ? k : 0]));
    const bool seen = rays == Rays::hits || isSeen(m, h);
    index[0][k] = seen ? h.i : 0;
    index[1][k] = seen ? h.j : 0;
    index[2][k] = seen ? h.u : 0;
    index[3][k] = seen ? h.v : 0;
    strip.seen[k] = seen ? ~0U : 0;
  }
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto last = static_cast<std::uint32_t>(m.count[axis]) - 1;
    for (std::size_t k = 0; k < stripSize; ++k) {
      const std::uint32_t cell = cellOf(index[axis][k]);
      strip.cell[axis][k] = rays == Rays::hits ? std::min(cell, last) : cell;
    }
  }
}

template <Rays rays, class Real>
inline __attribute__((always_inline)) void copyDesign(const HitMap& map, const BlockLayout& layout,
                                                      const Texel<std::uint8_t>* texels,
                                                      std::span<const RayRow> rows) {
  const RealMap<Real> m(map);
  const auto find = [m](const double* stripX, const double* stripY, CellStrip& strip)
      __attribute__((always_inline)) {
    findStrip<rays>(m, stripX, stripY, strip);
  };
  copyTexels<rays>(find, layout, texels, rows);
}

template <class Real>
inline __attribute__((always_inline)) void cellsIn(const HitMap& map, const double* x,
                                                   const double* y, int count, CellBatch& batch) {
  const RealMap<Real> m(map);
  IndexBatch<Real> found;
  for (std::size_t k = 0; k < std::size_t(count); ++k)
    keep(m, hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k])), k, found);
  split(found, count, batch);
}

MULTIVERSIONED
void linearCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch) {
  if (map.isSingle)
    cellsIn<float>(map, x, y, count, batch);
  else
    cellsIn<double>(map, x, y, count, batch);
}

template <class Real>
void curvedCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch) {
  const RealMap<Real> m(map);
  const auto [across, down] = map.panel.lenses;
  const auto directionOf = [](const HogelLens* lens, Real slope) {
    return static_cast<Real>(lens->directionOf(static_cast<double>(slope)));
  };
  constexpr auto half = static_cast<Real>(0.5);
  IndexBatch<Real> found;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    RealHit<Real> h = hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k]));
    h.u = m.count[2] * (half + directionOf(across, h.u));
    h.v = m.count[3] * (half - directionOf(down, h.v));
    keep(m, h, k, found);
  }
  split(found, count, batch);
}
}  // namespace

MULTIVERSIONED
void copyHits(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              std::span<const RayRow> rows) {
  if (map.isSingle)
    copyDesign<Rays::hits, float>(map, layout, texels, rows);
  else
    copyDesign<Rays::hits, double>(map, layout, texels, rows);
}

MULTIVERSIONED
void copyRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              std::span<const RayRow> rows) {
  if (map.isSingle)
    copyDesign<Rays::any, float>(map, layout, texels, rows);
  else
    copyDesign<Rays::any, double>(map, layout, texels, rows);
}

MULTIVERSIONED
void findStripCells(const HitMap& map, const double* x, const double* y, int count,
                    CellStrip& strip) {
  Strip<double> paddedX;
  Strip<double> paddedY;
  padStrip<Rays::any>(x, y, count, paddedX, paddedY);
  findStrip<Rays::any>(RealMap<double>(map), x, y, strip);
}

void findCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch,
               std::size_t channel) {
  if (map.panel.sheet != nullptr)
    findSheetCells(map, x, y, count, channel, batch);
  else if (map.panel.twin != nullptr)
    findTwinCells(map, x, y, count, channel, batch);
  else if (map.panel.lenses[0] == nullptr)
    linearCells(map, x, y, count, batch);
  else if (map.isSingle)
    curvedCells<float>(map, x, y, count, batch);
  else
    curvedCells<double>(map, x, y, count, batch);
}

bool fillUnseen(int count, CellBatch& batch) {
  const auto end = batch.seen.begin() + count;
  if (count == batchSize && std::find(batch.seen.begin(), end, std::uint8_t{0}) == end) return true;
  const auto hit = std::find(batch.seen.begin(), end, std::uint8_t{255});
  if (hit == end) return false;
  std::fill(end, batch.seen.end(), std::uint8_t{0});
  const auto at = std::size_t(hit - batch.seen.begin());
  for (auto& cell : batch.cell)
    for (std::size_t k = 0; k < batchSize; ++k) cell[k] = batch.seen[k] == 0 ? cell[at] : cell[k];
  return true;
}

}  // namespace hogelscope
