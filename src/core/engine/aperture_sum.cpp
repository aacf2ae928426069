// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/aperture_sum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/engine/ray_light.h"

namespace hogelscope {

namespace {

/// The linear light of each code value of 8 bits.
const std::array<float, 256>& linearLight() {
  static const std::array<float, 256> light = [] {
    std::array<float, 256> values{};
    for (int code = 0; code < 256; ++code)
      values[std::size_t(code)] = static_cast<float>(linearFromEncoded(code));
    return values;
  }();
  return light;
}

void findLight(const Texel<std::uint8_t>* texels, const std::uint32_t* address, int count,
               LightBatch& light) {
  const std::array<float, 256>& linear = linearLight();
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const Texel<std::uint8_t>& texel = texels[address[k]];
    light.r[k] = linear[texel.r];
    light.g[k] = linear[texel.g];
    light.b[k] = linear[texel.b];
  }
}

void addSeen(const LightBatch& light, const std::array<std::uint8_t, batchSize>& seen, float weight,
             LightBatch& sum) {
  for (std::size_t k = 0; k < batchSize; ++k) {
    const float share = seen[k] == 0 ? 0 : weight;
    sum.r[k] += share * light.r[k];
    sum.g[k] += share * light.g[k];
    sum.b[k] += share * light.b[k];
  }
}

}  // namespace

/// Texels of any pixels of a batch, whose light is found together.
struct TexelQueue {
  CellBatch cells{};
  std::array<std::uint32_t, batchSize> address{};  ///< in place of cells for texels of 8 bits
  std::array<std::uint8_t, batchSize> pixel{};
  std::array<float, batchSize> points{};
  int count = 0;
};

/// Working memory of a row.
struct ApertureSum::Scratch {
  Scratch(std::size_t raysOfPoint, std::size_t points)
      : ideals(raysOfPoint), keys(points), unique(points), counts(points) {}

  LightBatch light{};
  LightBatch point{};
  LightBatch sum{};
  std::vector<IdealBatch> ideals;  ///< of the rays from any point
  RayLight::Scratch rays;
  std::array<std::uint8_t, batchSize> seen{};    ///< from one point
  std::array<std::int32_t, batchSize> seeing{};  ///< points that see the display
  MiddleBatch middle{};
  std::array<PixelSpread, batchSize> spreads{};
  std::vector<std::uint32_t> keys;
  std::vector<std::uint32_t> unique;
  std::vector<std::int32_t> counts;
  TexelQueue queue;
};

namespace {

/// Estimates, in processor cycles for a pixel, whether it pays to look for the texels that several
/// points meet.
bool paysToShare(const Aperture& aperture, const Plan& plan) {
  const auto points = double(aperture.points.size());
  const double window = 2 * plan.psfReach + 1;
  const double texel = 20 + 4 * window * window;
  const double across = (aperture.directions + 1) * (aperture.hogels + 1);
  const double texels = std::min(points, across * across);
  return texels * (0.2 * points + texel) < points * texel;
}

}  // namespace

ApertureSum::ApertureSum(const ViewRays& rays, const LightField& texels, const TexelFilter& filter)
    : m_rays(rays), m_texels(texels), m_filter(filter) {
  const RenderJob& job = rays.job();
  const Plan& plan = rays.plan();
  const Vec3& eye = rays.middle().eye;
  for (std::size_t point = 0; point < rays.points(); ++point) {
    const Vec3 offset = rays.eye(point) - eye;
    m_offsets.x.push_back(static_cast<float>(offset.x));
    m_offsets.y.push_back(static_cast<float>(offset.y));
    m_offsets.z.push_back(static_cast<float>(offset.z));
    m_offsets.isFlat = m_offsets.isFlat && offset.z == 0;
    m_radius = std::max({m_radius, std::abs(offset.x), std::abs(offset.y)});
    m_depth = std::max(m_depth, std::abs(offset.z));
  }
  if (!plan.sumsTexels && texels.type() == StoredType::uint8)
    m_bytes = std::get<TexelArray<std::uint8_t>>(texels.texels()).data();
  m_shares = job.sampling.reconstruction == Reconstruction::nearest &&
             job.sampling.samplesPerPixel == 1 && plan.hasLinearHogels && !plan.movesRays &&
             !plan.changesLight && !plan.drivesTexels && !plan.leaksOverField &&
             !job.method.isSingle && eye.z > m_depth && paysToShare(plan.aperture, plan);
}

void ApertureSum::row(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const auto scratch = std::make_unique<Scratch>(m_rays.samplesFrom(0).size(), m_rays.points());
  const auto points = static_cast<std::int32_t>(m_rays.points());
  for (int first = x0; first < x1; first += batchSize) {
    const int count = std::min(batchSize, x1 - first);
    addBatch(y, first, count, *scratch);
    encodeMean(scratch->sum, points);
    for (std::size_t k = 0; k < std::size_t(count); ++k) {
      const std::size_t pixel = std::size_t(first - x0) + k;
      seen[pixel] = scratch->seeing[k] == points ? 255 : 0;
      rgb[3 * pixel] = scratch->sum.r[k];
      rgb[3 * pixel + 1] = scratch->sum.g[k];
      rgb[3 * pixel + 2] = scratch->sum.b[k];
    }
  }
}

void ApertureSum::addBatch(int y, int x0, int count, Scratch& scratch) const {
  scratch.sum = {};
  scratch.seeing = {};
  const auto samples = m_rays.samplesFrom(0);
  for (std::size_t s = 0; s < samples.size(); ++s)
    m_rays.ideals(y, x0, count, samples[s], scratch.ideals[s]);
  if (m_shares && findSpreads(count, scratch)) return addShared(count, scratch);
  for (std::size_t point = 0; point < m_rays.points(); ++point) addPoint(point, count, scratch);
}

/// Adds the light from one point: the mean of its rays.
void ApertureSum::addPoint(std::size_t point, int count, Scratch& scratch) const {
  scratch.point = {};
  scratch.seen = {};
  const float share = 1 / static_cast<float>(scratch.ideals.size());
  const RayLight light(m_rays, m_filter);
  for (const IdealBatch& ideals : scratch.ideals) {
    if (!light.find(ideals, count, point, scratch.rays, scratch.light)) continue;
    addSeen(scratch.light, scratch.rays.seen(), share, scratch.point);
    for (std::size_t k = 0; k < batchSize; ++k) scratch.seen[k] |= scratch.rays.seen()[k];
  }
  if (!m_rays.plan().sumsLinear) decode(scratch.point);
  addSeen(scratch.point, scratch.seen, 1, scratch.sum);
  for (std::size_t k = 0; k < batchSize; ++k) scratch.seeing[k] += scratch.seen[k] != 0 ? 1 : 0;
}

/// Finds how the points' cells spread around the middle's, for each pixel of a batch; its `h` is 0
/// where no point sees the display. Returns false if a pixel's cells are too far apart for
/// uniqueCells(), or its rays graze the panel.
bool ApertureSum::findSpreads(int count, Scratch& scratch) const {
  const ApertureMiddle& middle = m_rays.middle();
  const double focus = m_rays.plan().aperture.focus;
  MiddleBatch& rays = scratch.middle;
  findMiddles(middle.map, scratch.ideals[0].x, scratch.ideals[0].y, count, rays);
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    PixelSpread& spread = scratch.spreads[k] = {};
    // No ray, or all of them lead away from the panel.
    if (!(rays.d[k] <= m_depth / focus)) continue;
    const double h = 1 / (focus * rays.d[k]);
    if (!(std::abs(m_depth * h) < 0.5)) return false;
    const double steepest = std::max(std::abs(rays.a[k]), std::abs(rays.b[k]));
    const double most = 2 * (m_radius + m_depth * steepest);  // of w q
    bool isBeside = false;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const PanelMap& panel = middle.map.panel;
      const double gain = middle.perMetre[axis] - panel.slope[axis] * h;
      const double away = most * std::abs(gain);
      const double index = rays.index[axis][k];
      if (!(away < mostCellsAway - 1)) return false;
      isBeside = isBeside || !(index + away >= 0 && index - away < panel.count[axis]);
      spread.gain[axis] = static_cast<float>(gain);
      spread.place[axis] = static_cast<float>(index - std::floor(index));
    }
    if (isBeside) continue;
    spread.a = static_cast<float>(rays.a[k]);
    spread.b = static_cast<float>(rays.b[k]);
    spread.h = static_cast<float>(h);
  }
  return true;
}

/// Adds the light of all points, that of each texel once for all points that meet it.
void ApertureSum::addShared(int count, Scratch& scratch) const {
  const LightFieldSize& size = m_rays.job().lightField->size();
  const std::array counts{size.nx, size.ny, size.du, size.dv};
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const PixelSpread& spread = scratch.spreads[k];
    if (spread.h == 0) continue;
    std::array<int, 4> middle{};
    for (std::size_t axis = 0; axis < 4; ++axis)
      middle[axis] = static_cast<int>(std::floor(scratch.middle.index[axis][k]));
    const int found = uniqueCells(m_offsets, spread, scratch.keys.data(), scratch.unique.data(),
                                  scratch.counts.data());
    for (std::size_t each = 0; each < std::size_t(found); ++each) {
      std::array<int, 4> cell = cellsAway(scratch.unique[each]);
      bool isInside = true;
      for (std::size_t axis = 0; axis < 4; ++axis) {
        cell[axis] += middle[axis];
        isInside = isInside && cell[axis] >= 0 && cell[axis] < counts[axis];
      }
      // On the panel's edge float arithmetic may see what no ray of the footprint does.
      if (!isInside || !isInMemory(cell)) continue;
      scratch.seeing[k] += scratch.counts[each];
      addTexel(cell, static_cast<float>(scratch.counts[each]), k, scratch);
    }
  }
  emptyQueue(scratch);
}

/// Whether a texel, and those that leak into it, are in memory.
bool ApertureSum::isInMemory(const std::array<int, 4>& cell) const {
  const SliceLayout* const slice = m_texels.sliceLayout();
  if (slice == nullptr) return true;
  const auto [nx, ny, du, dv] = m_texels.size();
  const int reach = m_rays.plan().psfReach;
  const auto around = [reach](int direction, int count) {
    return CellRange{std::max(direction - reach, 0), std::min(direction + reach, count - 1)};
  };
  return slice->footprint.u[std::size_t(cell[0])].covers(around(cell[2], du)) &&
         slice->footprint.v[std::size_t(cell[1])].covers(around(cell[3], dv));
}

/// Adds a texel's light for so many points, later and with others. Texels that are only copied are
/// fetched from memory meanwhile.
void ApertureSum::addTexel(const std::array<int, 4>& cell, float points, std::size_t pixel,
                           Scratch& scratch) const {
  TexelQueue& queue = scratch.queue;
  const auto at = static_cast<std::size_t>(queue.count++);
  const auto own = [&](std::size_t axis) { return static_cast<std::uint32_t>(cell[axis]); };
  if (m_bytes != nullptr) {
    const BlockLayout& layout = m_texels.layout();
    queue.address[at] = layout.i(own(0)) + layout.j(own(1)) + layout.u(own(2)) + layout.v(own(3));
    __builtin_prefetch(m_bytes + queue.address[at]);
  } else {
    for (std::size_t axis = 0; axis < 4; ++axis) queue.cells.cell[axis][at] = own(axis);
  }
  queue.pixel[at] = static_cast<std::uint8_t>(pixel);
  queue.points[at] = points;
  if (queue.count == batchSize) emptyQueue(scratch);
}

void ApertureSum::emptyQueue(Scratch& scratch) const {
  TexelQueue& queue = scratch.queue;
  if (queue.count == 0) return;
  if (m_bytes != nullptr) {
    findLight(m_bytes, queue.address.data(), queue.count, scratch.light);
  } else {
    for (auto& cell : queue.cells.cell) std::fill(cell.begin() + queue.count, cell.end(), cell[0]);
    m_filter.sum(queue.count, queue.cells, scratch.rays.taps, scratch.light);
    if (!m_rays.plan().sumsLinear) decode(scratch.light);
  }
  for (std::size_t k = 0; k < std::size_t(queue.count); ++k) {
    const std::size_t pixel = queue.pixel[k];
    scratch.sum.r[pixel] += queue.points[k] * scratch.light.r[k];
    scratch.sum.g[pixel] += queue.points[k] * scratch.light.g[k];
    scratch.sum.b[pixel] += queue.points[k] * scratch.light.b[k];
  }
  queue.count = 0;
}

}  // namespace hogelscope
