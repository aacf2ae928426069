// SPDX-License-Identifier: BSD-3-Clause
// Which directional pixels a view may read.
#include "core/engine/view_footprint.h"

#include <algorithm>

namespace hogelscope {

namespace {

/// The directions that a ray's cell takes light from, with those of its neighbour hogels.
struct Reach {
  int hogels;
  int directions;
};

void widen(std::vector<CellRange>& ranges, int cell, int direction, const Reach& reach, int count) {
  const CellRange range{std::max(direction - reach.directions, 0),
                        std::min(direction + reach.directions, count - 1)};
  const int last = std::min(cell + reach.hogels, int(ranges.size()) - 1);
  for (int k = std::max(cell - reach.hogels, 0); k <= last; ++k)
    ranges[std::size_t(k)].include(range);
}

}  // namespace

Footprint footprint(const FastSimulation& simulation, const View& view, int y, int x0, int x1) {
  const auto [nx, ny, du, dv] = view.lightField->size();
  Footprint result{std::vector<CellRange>(std::size_t(nx)),
                   std::vector<CellRange>(std::size_t(ny))};
  const Reconstruction reconstruction = view.sampling.reconstruction;
  const Reach reach{
      reconstruction == Reconstruction::quadrilinear ? 1 : 0,
      simulation.plan().psfReach + (reconstruction == Reconstruction::nearest ? 0 : 1)};
  CellBatch batch;
  const int n = view.sampling.samplesPerPixel;
  for (int x = x0; x < x1; x += batchSize)
    for (int s = 0; s < n * n; ++s) {
      const int count = std::min(batchSize, x1 - x);
      simulation.cells(y, x, count, s % n, s / n, batch);
      for (std::size_t k = 0; k < std::size_t(count); ++k) {
        if (batch.seen[k] == 0) continue;
        widen(result.u, int(batch.cell[0][k]), int(batch.cell[2][k]), reach, du);
        widen(result.v, int(batch.cell[1][k]), int(batch.cell[3][k]), reach, dv);
      }
    }
  return result;
}

}  // namespace hogelscope
