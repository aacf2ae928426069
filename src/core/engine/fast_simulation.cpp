// SPDX-License-Identifier: BSD-3-Clause
// The fast engine: rays in batches, their addresses one batch ahead of their texels.
#include "core/engine/fast_simulation.h"

#include <algorithm>
#include <cstring>

#include "core/engine/aperture_sum.h"
#include "core/engine/ray_light.h"
#include "core/engine/sheet_kernels.h"
#include "core/engine/twin_kernels.h"
#include "core/panel/twin.h"

namespace hogelscope {

struct FastSimulation::Scratch {
  IdealBatch ideals{};
  RayLight::Scratch rays;
  LightBatch sum{};
};

FastSimulation::FastSimulation(const RenderJob& job, LensTables& tables,
                               const ParallelRows& parallelRows, const Progress& progress)
    : m_rays(job, tables, parallelRows, progress),
      m_texels(job.lightField->slice(m_rays.reads(parallelRows), part(m_rays.progress(), 0, 0))),
      m_filter(m_texels, job, m_rays.plan()) {
  if (m_rays.plan().usesStrips) m_fixedMap = FixedMap::of(m_rays.map(0));
}

void FastSimulation::row(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  throwIfCancelled(m_rays.progress());
  const auto count = std::size_t(x1 - x0);
  std::memset(rgb, 0, 3 * count);
  std::memset(seen, 0, count);
  if (m_rays.seesNothing()) return;
  if (m_rays.plan().copiesTexels && m_rays.plan().knowsOutline)
    return copyPlainRow(y, x0, x1, rgb, seen);
  if (m_rays.plan().copiesTexels && m_rays.lens() != nullptr && m_rays.plan().hasLinearHogels &&
      !m_rays.plan().movesRays)
    return copyRow(y, x0, x1, rgb, seen);
  if (m_rays.plan().copiesTexels && m_rays.plan().isSimpleTwin &&
      (m_rays.lens() != nullptr || !m_rays.plan().hasLens))
    return copyTwinRow(y, x0, x1, rgb, seen);
  if (m_rays.plan().copiesPixels && (m_rays.lens() != nullptr || !m_rays.plan().hasLens))
    return copySheetRow(y, x0, x1, rgb, seen);
  std::vector<float> sums(3 * count);
  sumRow(y, x0, x1, sums.data(), seen);
  quantise(sums.data(), int(sums.size()), rgb);
}

void FastSimulation::row(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const auto count = std::size_t(x1 - x0);
  std::fill(rgb, rgb + 3 * count, 0.0F);
  std::memset(seen, 0, count);
  if (!m_rays.seesNothing()) sumRow(y, x0, x1, rgb, seen);
}

void FastSimulation::copyPlainRow(int y, int x0, int x1, std::uint8_t* rgb,
                                  std::uint8_t* seen) const {
  const auto [first, last] = m_rays.seenPart(y, x0, x1);
  if (first == last) return;
  std::memset(seen + (first - x0), 255, std::size_t(last - first));
  copyHits(m_rays.map(0), m_texels->layout(), byteTexels(), m_rays.plainX(first), m_rays.plainY(y),
           last - first, rgb + std::ptrdiff_t(3) * (first - x0));
}

void FastSimulation::copyRow(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  const LensTable& lens = *m_rays.lens();
  const RaySample& sample = m_rays.samplesFrom(0).front();
  if (m_fixedMap && x0 == 0)
    return copyLensRays(*m_fixedMap, m_texels->layout(), byteTexels(), lens.strips(y),
                        lens.x(y, sample), lens.y(y, sample), x1, rgb, seen);
  copyRays(m_rays.map(0), m_texels->layout(), byteTexels(), lens.x(y, sample) + x0,
           lens.y(y, sample) + x0, x1 - x0, rgb, seen);
}

void FastSimulation::copyTwinRow(int y, int x0, int x1, std::uint8_t* rgb,
                                 std::uint8_t* seen) const {
  const HitMap& map = m_rays.map(0);
  const auto copy = [&](const double* xs, const double* ys) {
    copyTwinRays(map, m_texels->layout(), byteTexels(), xs, ys, x1 - x0, rgb, seen);
  };
  if (const LensTable* lens = m_rays.lens(); lens != nullptr) {
    const RaySample& sample = m_rays.samplesFrom(0).front();
    return copy(lens->x(y, sample) + x0, lens->y(y, sample) + x0);
  }
  if (!map.panel.twin->isAffine()) {
    const std::vector<double> plainY(std::size_t(x1 - x0), m_rays.plainY(y));
    return copy(m_rays.plainX(x0), plainY.data());
  }
  const std::array<int, 4> parts = m_rays.twinParts(y, x0, x1);
  const std::ptrdiff_t from = parts[0] - x0;
  if (parts[0] < parts[3])
    hogelscope::copyTwinRow(map, m_texels->layout(), byteTexels(), m_rays.plainX(parts[0]),
                            m_rays.plainY(y), parts, rgb + 3 * from, seen + from);
}

void FastSimulation::copySheetRow(int y, int x0, int x1, std::uint8_t* rgb,
                                  std::uint8_t* seen) const {
  const HitMap& map = m_rays.map(0);
  if (const LensTable* lens = m_rays.lens(); lens != nullptr) {
    const RaySample& sample = m_rays.samplesFrom(0).front();
    return copySheetRays(map, m_texels->layout(), byteTexels(), lens->x(y, sample) + x0,
                         lens->y(y, sample) + x0, x1 - x0, rgb, seen);
  }
  hogelscope::copySheetRow(map, m_texels->layout(), byteTexels(), m_rays.plainX(x0),
                           m_rays.plainY(y), x1 - x0, rgb, seen);
}

const Texel<std::uint8_t>* FastSimulation::byteTexels() const {
  return std::get<TexelArray<std::uint8_t>>(m_texels->texels()).data();
}

void FastSimulation::sumRow(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  if (!m_rays.plan().aperture.isPinhole)
    return ApertureSum(m_rays, *m_texels, m_filter).row(y, x0, x1, rgb, seen);
  const auto [begin, end] =
      m_rays.plan().knowsOutline ? m_rays.seenPart(y, x0, x1) : std::array{x0, x1};
  const auto scratch = std::make_unique<Scratch>();
  const RayLight light(m_rays, m_filter);
  const float share = 1 / static_cast<float>(m_rays.samplesFrom(0).size());
  for (int first = begin; first < end; first += batchSize) {
    const int count = std::min(batchSize, end - first);
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
