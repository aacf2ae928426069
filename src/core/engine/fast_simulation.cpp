// SPDX-License-Identifier: BSD-3-Clause
// The fast engine: rays in batches, their addresses one batch ahead of their texels.
#include "core/engine/fast_simulation.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hogelscope {

struct FastSimulation::Scratch {
  CellBatch cells{};
  TexelFilter::Scratch taps;
  LightBatch sum{};
};

FastSimulation::FastSimulation(const RenderJob& job, LensTables& tables,
                               const ParallelRows& parallelRows, const Progress& progress)
    : m_rays(job, tables, parallelRows, progress),
      m_texels(job.lightField->slice(m_rays.reads(parallelRows), part(m_rays.progress(), 0, 0))),
      m_filter(m_texels, job, m_rays.plan()) {}

void FastSimulation::row(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  hearStop(m_rays.progress());
  const auto count = std::size_t(x1 - x0);
  std::memset(rgb, 0, 3 * count);
  std::memset(seen, 0, count);
  if (m_rays.seesNothing()) return;
  if (m_rays.plan().copiesTexels && m_rays.plan().knowsOutline)
    return copyPlainRow(y, x0, x1, rgb, seen);
  if (m_rays.plan().copiesTexels && m_rays.lens() != nullptr && m_rays.plan().hasLinearHogels)
    return copyRow(y, x0, x1, rgb, seen);
  std::vector<float> sums(3 * count);
  sumRow(y, x0, x1, sums.data(), seen);
  for (std::size_t k = 0; k < sums.size(); ++k) rgb[k] = quantised(double(sums[k]));
}

void FastSimulation::row(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const auto count = std::size_t(x1 - x0);
  std::fill(rgb, rgb + 3 * count, 0.0F);
  std::memset(seen, 0, count);
  if (!m_rays.seesNothing()) sumRow(y, x0, x1, rgb, seen);
}

namespace {

using ByteTexel = Texel<std::uint8_t>;

/// Computes the next batch's addresses while a batch's texels come from memory.
template <class AddressesOf, class Take>
void inBatches(int begin, int end, const ByteTexel* texels, AddressesOf addressesOf, Take take) {
  std::array<std::array<std::uint32_t, batchSize>, 2> address;
  std::array<ByteTexel, batchSize> found;
  int previous = begin;
  std::size_t turn = 0;
  for (int x = begin; previous < end; x += batchSize, turn = 1 - turn) {
    const int count = std::min(batchSize, end - x);
    if (count > 0) {
      addressesOf(x, count, address[turn].data());
      prefetch(texels, address[turn].data(), count);
    }
    if (x == begin) continue;
    const int before = std::min(batchSize, end - previous);
    gather(texels, address[1 - turn].data(), before, found.data());
    take(previous, before, address[1 - turn].data(), found.data());
    previous += before;
  }
}

}  // namespace

void FastSimulation::copyPlainRow(int y, int x0, int x1, std::uint8_t* rgb,
                                  std::uint8_t* seen) const {
  const auto [first, last] = m_rays.seenPart(y, x0, x1);
  const double py = m_rays.plainY(y);
  const BlockLayout& layout = m_texels->layout();
  std::memset(seen + (first - x0), 255, std::size_t(last - first));
  inBatches(
      first, last, std::get<TexelArray<std::uint8_t>>(m_texels->texels()).data(),
      [&](int x, int count, std::uint32_t* address) {
        addressesOfHits(m_rays.map(), layout, m_rays.plainX(x), py, count, address);
      },
      [&](int x, int count, const std::uint32_t*, const ByteTexel* found) {
        packRgb(found, count, rgb + std::ptrdiff_t(3) * (x - x0));
      });
}

void FastSimulation::copyRow(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  const BlockLayout& layout = m_texels->layout();
  const std::uint32_t unseen = layout.texels;  // the black texel behind all others
  const double* px = m_rays.lens()->x(y, 0, 0);
  const double* py = m_rays.lens()->y(y, 0, 0);
  inBatches(
      x0, x1, std::get<TexelArray<std::uint8_t>>(m_texels->texels()).data(),
      [&](int x, int count, std::uint32_t* address) {
        addresses(m_rays.map(), layout, px + x, py + x, count, unseen, address);
      },
      [&](int x, int count, const std::uint32_t* address, const ByteTexel* found) {
        packRgb(found, count, rgb + std::ptrdiff_t(3) * (x - x0));
        maskSeen(address, count, unseen, seen + (x - x0));
      });
}

namespace {

/// Gives lanes without a hit the cells of one with a hit, so that whole batches stay away from
/// borders. Returns false if there is none.
bool fillUnseen(int count, CellBatch& batch) {
  const auto end = batch.seen.begin() + count;
  const auto hit = std::find(batch.seen.begin(), end, std::uint8_t{255});
  if (hit == end) return false;
  std::fill(end, batch.seen.end(), std::uint8_t{0});
  const auto at = std::size_t(hit - batch.seen.begin());
  for (auto& cell : batch.cell)
    for (std::size_t k = 0; k < batchSize; ++k) cell[k] = batch.seen[k] == 0 ? cell[at] : cell[k];
  return true;
}

}  // namespace

/// Finds the cells of the rays of `count` pixels from x0 on. Returns false if none of them hits.
bool FastSimulation::castRays(int y, int x0, int count, int sx, int sy, Scratch& scratch) const {
  m_rays.cells(y, x0, count, sx, sy, scratch.cells);
  return fillUnseen(count, scratch.cells);
}

void FastSimulation::sumRow(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const auto [begin, end] =
      m_rays.plan().knowsOutline ? m_rays.seenPart(y, x0, x1) : std::array{x0, x1};
  const auto scratch = std::make_unique<Scratch>();
  const int n = m_rays.job().sampling.samplesPerPixel;
  const float share = 1 / static_cast<float>(n * n);
  for (int first = begin; first < end; first += batchSize) {
    const int count = std::min(batchSize, end - first);
    for (int s = 0; s < n * n; ++s) {
      if (!castRays(y, first, count, s % n, s / n, *scratch)) continue;
      m_filter.sum(count, scratch->cells, scratch->taps, scratch->sum);
      for (int k = 0; k < count; ++k) {
        const auto ray = std::size_t(k);
        if (scratch->cells.seen[ray] == 0) continue;
        const auto pixel = std::size_t(first - x0) + ray;
        seen[pixel] = 255;
        rgb[3 * pixel] += share * scratch->sum.r[ray];
        rgb[3 * pixel + 1] += share * scratch->sum.g[ray];
        rgb[3 * pixel + 2] += share * scratch->sum.b[ray];
      }
    }
  }
  if (!m_rays.plan().sumsLinear) return;
  for (int k = 0; k < 3 * (x1 - x0); ++k)
    rgb[k] = static_cast<float>(encodedFromLinear(double(rgb[k])));
}

}  // namespace hogelscope
