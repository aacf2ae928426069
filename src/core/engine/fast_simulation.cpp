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

void FastSimulation::rows(int y0, int y1, int x0, int x1, std::uint8_t* rgb,
                          std::uint8_t* seen) const {
  const Plan& plan = m_rays.plan();
  const bool isPlain = plan.copiesTexels && plan.knowsOutline;
  const bool hasStrips = m_fixedMap && x0 == 0;
  const bool isTogether = !m_rays.seesNothing() && (isPlain || hasStrips);
  for (int y = y0, end = y0; y < y1; y = end) {
    throwIfCancelled(m_rays.progress());
    end = isTogether ? std::min(y + mostTogether, y1) : y + 1;
    const std::ptrdiff_t first = std::ptrdiff_t(y - y0) * (x1 - x0);
    if (!isTogether)
      row(y, x0, x1, rgb + 3 * first, seen + first);
    else if (isPlain)
      copyPlainRows(y, end, x0, x1, rgb + 3 * first, seen + first);
    else
      copyLensRows(y, end, x1, rgb + 3 * first, seen + first);
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

void FastSimulation::row(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  const auto count = std::size_t(x1 - x0);
  std::memset(rgb, 0, 3 * count);
  std::memset(seen, 0, count);
  if (m_rays.seesNothing()) return;
  const Plan& plan = m_rays.plan();
  const bool hasRays = m_rays.lens() != nullptr || !plan.hasLens;
  if (plan.copiesTexels && m_rays.lens() != nullptr && plan.hasLinearHogels && !plan.movesRays)
    return copyTableRow(y, x0, x1, rgb, seen);
  if (plan.copiesTexels && plan.isSimpleTwin && hasRays) return copyTwinRow(y, x0, x1, rgb, seen);
  if (plan.copiesPixels && hasRays) return copySheetRow(y, x0, x1, rgb, seen);
  std::vector<float> sums(3 * count);
  sumRow(y, x0, x1, sums.data(), seen);
  quantise(sums.data(), int(sums.size()), rgb);
}

void FastSimulation::copyPlainRows(int y0, int y1, int x0, int x1, std::uint8_t* rgb,
                                   std::uint8_t* seen) const {
  std::array<double, mostTogether> ys;
  std::array<RayRow, mostTogether> rows;
  const int width = x1 - x0;
  for (int y = y0; y < y1; ++y, rgb += 3 * width, seen += width) {
    const auto row = std::size_t(y - y0);
    const auto [begin, end] = m_rays.seenPart(y, x0, x1);
    const int left = begin - x0;
    const int hits = end - begin;
    const int right = width - left - hits;
    std::memset(rgb, 0, std::size_t(3 * left));
    std::memset(rgb + 3 * (left + hits), 0, std::size_t(3 * right));
    std::memset(seen, 0, std::size_t(left));
    std::memset(seen + left, 255, std::size_t(hits));
    std::memset(seen + left + hits, 0, std::size_t(right));
    ys[row] = m_rays.plainY(y);
    rows[row] = {m_rays.plainX(begin), &ys[row], hits, rgb + 3 * left, nullptr};
  }
  copyHits(m_rays.map(0), m_texels->layout(), byteTexels(),
           std::span(rows).first(std::size_t(y1 - y0)));
}

void FastSimulation::copyLensRows(int y0, int y1, int width, std::uint8_t* rgb,
                                  std::uint8_t* seen) const {
  const LensTable& lens = *m_rays.lens();
  const RaySample& sample = m_rays.samplesFrom(0).front();
  const std::size_t inRow = LensStrips::inRow(m_rays.job().state.camera.res[0]);
  std::array<LensRow, mostTogether> rows;
  for (int y = y0; y < y1; ++y, rgb += 3 * width, seen += width)
    rows[std::size_t(y - y0)] = {{lens.x(y, sample), lens.y(y, sample), width, rgb, seen},
                                 inRow * std::size_t(y)};
  copyLensRays(*m_fixedMap, m_texels->layout(), byteTexels(), lens.strips(),
               std::span(rows).first(std::size_t(y1 - y0)));
}

void FastSimulation::copyTableRow(int y, int x0, int x1, std::uint8_t* rgb,
                                  std::uint8_t* seen) const {
  const LensTable& lens = *m_rays.lens();
  const RaySample& sample = m_rays.samplesFrom(0).front();
  const RayRow row{lens.x(y, sample) + x0, lens.y(y, sample) + x0, x1 - x0, rgb, seen};
  copyRays(m_rays.map(0), m_texels->layout(), byteTexels(), std::span(&row, 1));
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
