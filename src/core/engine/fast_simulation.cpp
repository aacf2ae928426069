// SPDX-License-Identifier: BSD-3-Clause
// The fast engine: rays in batches, their addresses one batch ahead of their texels.
#include "core/engine/fast_simulation.h"

#include <algorithm>
#include <cstring>

#include "core/engine/aperture_sum.h"
#include "core/engine/ray_light.h"
#include "core/engine/row_kernels.h"

namespace hogelscope {

namespace {

constexpr int mostTogether = 16;  ///< rows

}  // namespace

struct FastSimulation::Scratch {
  IdealBatch ideals{};
  RayLight::Scratch rays;
  LightBatch sum{};
};

FastSimulation::FastSimulation(const RenderJob& job, LensTables& tables,
                               const ParallelRows& parallelRows, const Progress& progress)
    : m_rays(job, tables, parallelRows, progress),
      m_texels(job.lightField->slice(m_rays.reads(parallelRows), part(m_rays.progress(), 0, 0))),
      m_filter(m_texels, job, m_rays.plan()),
      m_copies((m_rays.plan().copiesTexels || m_rays.plan().copiesPixels) &&
               (m_rays.lens() != nullptr || !m_rays.plan().hasLens)) {
  if (m_rays.plan().usesStrips) m_fixedMap = FixedMap::of(m_rays.map(0));
}

void FastSimulation::rows(int y0, int y1, int x0, int x1, std::uint8_t* rgb,
                          std::uint8_t* seen) const {
  const std::size_t width = std::size_t(x1 - x0);
  const bool copies = m_copies && !m_rays.seesNothing();
  std::vector<float> sums(copies ? 0 : 3 * width);
  for (int y = y0, end = y0; y < y1; y = end) {
    throwIfCancelled(m_rays.progress());
    end = copies ? std::min(y + mostTogether, y1) : y + 1;
    std::uint8_t* const to = rgb + 3 * width * std::size_t(y - y0);
    std::uint8_t* const mask = seen + width * std::size_t(y - y0);
    if (copies) {
      copyRows(y, end, x0, x1, to, mask);
    } else {
      rows(y, end, x0, x1, sums.data(), mask);
      quantise(sums.data(), int(sums.size()), to);
    }
  }
}

void FastSimulation::rows(int y0, int y1, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const std::size_t width = std::size_t(x1 - x0);
  const std::size_t count = std::size_t(y1 - y0) * width;
  std::fill(rgb, rgb + 3 * count, 0.0F);
  std::memset(seen, 0, count);
  if (m_rays.seesNothing()) return;
  for (int y = y0; y < y1; ++y, rgb += 3 * width, seen += width) sumRow(y, x0, x1, rgb, seen);
}

void FastSimulation::copyRows(int y0, int y1, int x0, int x1, std::uint8_t* rgb,
                              std::uint8_t* seen) const {
  const HitMap& map = m_rays.map(0);
  const BlockLayout& layout = m_texels->layout();
  const auto* texels = std::get<TexelArray<std::uint8_t>>(m_texels->texels()).data();
  const std::ptrdiff_t width = x1 - x0;
  std::array<RayRow, mostTogether> rows;
  const auto made = std::span(rows).first(std::size_t(y1 - y0));
  if (const LensTable* lens = m_rays.lens(); lens != nullptr) {
    const RaySample& sample = m_rays.samplesFrom(0).front();
    const std::size_t strips = LensStrips::inRow(m_rays.job().state.camera.res[0]);
    for (int y = y0; y < y1; ++y, rgb += 3 * width, seen += width)
      made[std::size_t(y - y0)] = {
          lens->x(y, sample) + x0, lens->y(y, sample) + x0, x1 - x0, rgb, seen, {},
          strips * std::size_t(y)};
    if (m_fixedMap && x0 == 0)
      return copyLensRays(*m_fixedMap, layout, texels, lens->strips(), made);
    return copyRays(map, layout, texels, false, made);
  }
  std::array<double, mostTogether> ys;
  for (int y = y0; y < y1; ++y, rgb += 3 * width, seen += width) {
    const auto row = std::size_t(y - y0);
    const auto [begin, from, to, end] = m_rays.seenParts(y, x0, x1);
    const auto at = [&](int x) { return std::ptrdiff_t(x - x0); };
    const auto blacken = [&](int first, int last) {
      std::fill(rgb + 3 * at(first), rgb + 3 * at(last), std::uint8_t{0});
      std::fill(seen + at(first), seen + at(last), std::uint8_t{0});
    };
    blacken(x0, begin);
    blacken(end, x1);
    ys[row] = m_rays.plainY(y);
    made[row] = {m_rays.plainX(begin), &ys[row],         end - begin,
                 rgb + 3 * at(begin),  seen + at(begin), {from - begin, to - begin}};
  }
  copyRays(map, layout, texels, true, made);
}

void FastSimulation::sumRow(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  if (!m_rays.plan().aperture.isPinhole)
    return ApertureSum(m_rays, *m_texels, m_filter).row(y, x0, x1, rgb, seen);
  const std::array<int, 4> parts = m_rays.seenParts(y, x0, x1);
  const auto scratch = std::make_unique<Scratch>();
  const RayLight light(m_rays, m_filter);
  const float share = 1 / static_cast<float>(m_rays.samplesFrom(0).size());
  for (int first = parts[0]; first < parts[3]; first += batchSize) {
    const int count = std::min(batchSize, parts[3] - first);
    for (const RaySample& sample : m_rays.samplesFrom(0)) {
      m_rays.ideals(y, first, count, sample, scratch->ideals);
      if (!light.find(scratch->ideals, count, 0, scratch->rays, scratch->sum)) continue;
      for (int k = 0; k < count; ++k) {
        const auto ray = std::size_t(k);
        if (scratch->rays.seen()[ray] == 0) continue;
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
