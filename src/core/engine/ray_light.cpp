// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/ray_light.h"

#include "core/panel/twin.h"

namespace hogelscope {

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
    LightBatch& sum = c == 0 ? light : scratch.channel;
    m_filter.sum(count, cells[c], scratch.taps, sum);
    if (hasDead) dropDead(count, cells[c], sum);
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
