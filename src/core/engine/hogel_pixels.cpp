// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/hogel_pixels.h"

#include <algorithm>

namespace hogelscope {

namespace {

void addRuns(const ViewRays& rays, int y, std::uint32_t i, std::uint32_t j,
             std::vector<PixelRun>& runs) {
  const int width = rays.job().state.camera.res[0];
  for (int x0 = 0; x0 < width; x0 += batchSize) {
    const int count = std::min(batchSize, width - x0);
    CellBatch batch;
    rays.cells(y, x0, count, {}, batch);
    for (int k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (batch.seen[at] == 0 || batch.cell[0][at] != i || batch.cell[1][at] != j) continue;
      const int x = x0 + k;
      if (!runs.empty() && runs.back().x1 == x)
        ++runs.back().x1;
      else
        runs.push_back({y, x, x + 1});
    }
  }
}

}  // namespace

std::vector<PixelRun> pixelsSeeing(const RenderJob& job, int i, int j,
                                   const ParallelRows& parallelRows, const Progress& progress) {
  RenderJob middle = job;
  middle.sampling.samplesPerPixel = 1;
  middle.method = {};
  LensTables tables;
  const ViewRays rays(middle, tables, parallelRows, progress);
  if (rays.seesNothing()) return {};
  const int height = job.state.camera.res[1];
  std::vector<std::vector<PixelRun>> rows(static_cast<std::size_t>(height));
  parallelRows(height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      addRuns(rays, y, std::uint32_t(i), std::uint32_t(j), rows[std::size_t(y)]);
  });
  std::vector<PixelRun> runs;
  for (const auto& row : rows) runs.insert(runs.end(), row.begin(), row.end());
  return runs;
}

}  // namespace hogelscope
