// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/ray_light.h"

#include <algorithm>

#include "core/panel/twin.h"

namespace hogelscope {

RayLight::RayLight(const ViewRays& rays, const TexelFilter& filter)
    : m_rays(rays), m_filter(filter) {
  if (const LensSheet* sheet = rays.map(0).panel.display->sheet(); sheet != nullptr)
    m_spot = sheet->spot();
  if (rays.plan().leaksOverField) m_leakage.emplace(*rays.job().twin, rays.job().state.psf);
}

void RayLight::sum(int count, const CellBatch& cells, Scratch& scratch, LightBatch& light) const {
  if (m_leakage)
    sumField(count, cells, light);
  else if (!m_spot.empty())
    sumSpot(count, cells, scratch, light);
  else
    m_filter.sum(count, cells, scratch.taps, light);
}

/// Sums a lens sheet's pixels beside those that rays meet; beyond the panel there are none.
void RayLight::sumSpot(int count, const CellBatch& cells, Scratch& scratch,
                       LightBatch& light) const {
  const auto reach = static_cast<int>(m_spot.size() / 2);
  const int last = m_filter.texels().size().nx - 1;
  scratch.beside = cells;
  light = {};
  for (int t = -reach; t <= reach; ++t) {
    const auto share = static_cast<float>(m_spot[std::size_t(t + reach)]);
    std::array<float, batchSize> weight;
    for (std::size_t k = 0; k < batchSize; ++k) {
      const int i = static_cast<int>(cells.cell[0][k]) + t;
      weight[k] = i >= 0 && i <= last ? share : 0;
      scratch.beside.cell[0][k] = static_cast<std::uint32_t>(std::clamp(i, 0, last));
    }
    m_filter.sum(count, scratch.beside, scratch.taps, scratch.tap);
    for (std::size_t k = 0; k < batchSize; ++k) {
      light.r[k] += weight[k] * scratch.tap.r[k];
      light.g[k] += weight[k] * scratch.tap.g[k];
      light.b[k] += weight[k] * scratch.tap.b[k];
    }
  }
}

/// Sums the leakage of each ray's directions, one or the four around its hit.
void RayLight::sumField(int count, const CellBatch& cells, LightBatch& light) const {
  const RenderJob& job = m_rays.job();
  const bool isNearest = job.sampling.reconstruction == Reconstruction::nearest;
  const LightFieldSize& size = m_filter.texels().size();
  const auto lightOf = [&](const TexelIndex& tap) { return m_filter.lightOf(tap); };
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const auto own = [&](std::size_t axis) { return static_cast<int>(cells.cell[axis][k]); };
    std::array<int, 2> first{own(2), own(3)};
    std::array<double, 2> share{};
    for (std::size_t axis = 0; axis < 2 && !isNearest; ++axis) {
      const double place = double(cells.place[axis + 2][k]) - 0.5;
      first[axis] -= place < 0 ? 1 : 0;
      share[axis] = place < 0 ? place + 1 : place;
    }
    Rgb sum;
    for (int corner = 0; corner < (isNearest ? 1 : 4); ++corner) {
      const int right = corner % 2;
      const int below = corner / 2;
      const double weight =
          (right == 1 ? share[0] : 1 - share[0]) * (below == 1 ? share[1] : 1 - share[1]);
      if (weight == 0) continue;
      const TexelIndex at{own(0), own(1), std::clamp(first[0] + right, 0, size.du - 1),
                          std::clamp(first[1] + below, 0, size.dv - 1)};
      sum = sum + weight * m_leakage->leaked(size, at, lightOf);
    }
    light.r[k] = static_cast<float>(sum.r);
    light.g[k] = static_cast<float>(sum.g);
    light.b[k] = static_cast<float>(sum.b);
  }
}

bool RayLight::find(const IdealBatch& ideals, int count, std::size_t point, Scratch& scratch,
                    LightBatch& light) const {
  const Plan& plan = m_rays.plan();
  const std::size_t channels = plan.splitsColours ? 3 : 1;
  auto& cells = scratch.cells;
  const bool hasDead = plan.drivesTexels && m_rays.job().twin->hasDead();
  for (std::size_t c = 0; c < channels; ++c) m_rays.cellsOf(ideals, count, point, cells[c], c);
  if (plan.splitsColours)
    for (std::size_t k = 0; k < batchSize; ++k)
      cells[0].seen[k] = cells[1].seen[k] = cells[2].seen[k] =
          cells[0].seen[k] & cells[1].seen[k] & cells[2].seen[k];
  for (std::size_t c = 0; c < channels; ++c) {
    if (!fillUnseen(count, cells[c])) return false;
    LightBatch& found = c == 0 ? light : scratch.channel;
    sum(count, cells[c], scratch, found);
    if (hasDead) dropDead(count, cells[c], found);
    if (c == 1) light.g = scratch.channel.g;
    if (c == 2) light.b = scratch.channel.b;
  }
  if (plan.changesLight) change(count, scratch, light);
  return true;
}

/// Takes the light of dead hogels.
void RayLight::dropDead(int count, const CellBatch& cells, LightBatch& light) const {
  for (std::size_t k = 0; k < std::size_t(count); ++k)
    if (m_rays.job().twin->isDeadHogel(static_cast<int>(cells.cell[0][k]),
                                       static_cast<int>(cells.cell[1][k])))
      light.r[k] = light.g[k] = light.b[k] = 0;
}

void RayLight::change(int count, const Scratch& scratch, LightBatch& light) const {
  const Twin& twin = *m_rays.job().twin;
  const bool isSplit = m_rays.plan().splitsColours;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    if (scratch.seen()[k] == 0) continue;
    const auto hitOf = [&](std::size_t c) {
      const CellBatch& cells = scratch.cells[isSplit ? c : 0];
      const auto index = [&](std::size_t axis) {
        return double(cells.cell[axis][k]) + double(cells.place[axis][k]);
      };
      return Hit{index(0), index(1), index(2), index(3)};
    };
    const Rgb lit = twin.lit({hitOf(0), hitOf(1), hitOf(2)},
                             {double(light.r[k]), double(light.g[k]), double(light.b[k])});
    light.r[k] = static_cast<float>(lit.r);
    light.g[k] = static_cast<float>(lit.g);
    light.b[k] = static_cast<float>(lit.b);
  }
}

}  // namespace hogelscope
