// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/hogel_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

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

RenderJob middleRays(RenderJob job) {
  job.sampling.samplesPerPixel = 1;
  job.state.pupil = {};
  job.method = {};
  return job;
}

std::vector<PixelRun> pixelsSeeing(const RenderJob& job, int i, int j,
                                   const ParallelRows& parallelRows, const Progress& progress) {
  const RenderJob middle = middleRays(job);
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

std::vector<RayEnd> rayEnds(const RenderJob& job, std::span<const std::uint8_t> seen,
                            const ParallelRows& parallelRows, const Progress& progress) {
  SamplingParams middle = job.sampling;
  middle.samplesPerPixel = 1;
  const Progress ofThreads = forThreads(progress);
  const LensRays lens(lensKeyOf(job.state, middle), ofThreads);
  const Camera camera(job.state.camera, job.state.intrinsics);
  const Display display(job.display, job.twin);
  const RigidTransform toDisplay = display.displayFromWorld() * camera.worldFromCamera();
  const int width = job.state.camera.res[0];
  std::vector<RayEnd> ends(seen.size(), RayEnd::seen);
  const auto writeRow = [&](int y) {
    throwIfCancelled(ofThreads);
    std::array<double, batchSize> idealX;
    std::array<double, batchSize> idealY;
    for (int x0 = 0; x0 < width; x0 += batchSize) {
      const int count = std::min(batchSize, width - x0);
      const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x0);
      lens.row(y, {}, x0, count, idealX.data(), idealY.data());
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        if (seen[from + k] != 0) continue;
        const Vec3 direction = toDisplay.direction({idealX[k], idealY[k], 1});
        ends[from + k] = std::isnan(idealX[k])
                             ? RayEnd::noRay
                             : endOf(display, display.intersectPlane(toDisplay.origin, direction));
      }
    }
  };
  parallelRows(job.state.camera.res[1], [&](int begin, int end) {
    for (int y = begin; y < end; ++y) writeRow(y);
  });
  return ends;
}

}  // namespace hogelscope
