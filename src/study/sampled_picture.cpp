// SPDX-License-Identifier: BSD-3-Clause
#include "study/sampled_picture.h"

#include <algorithm>

#include "core/engine/scaled_view.h"

namespace hogelscope {

namespace {

constexpr int bandRows = 8;

/// Returns the view of a single band.
RenderJob bandOf(const RenderJob& job, const Band& band) {
  RenderJob part = job;
  CameraState& state = part.state;
  const Camera camera(state.camera, state.intrinsics);
  state.camera.res[1] = band.end - band.begin;
  state.intrinsics = {camera.focalLength().x, camera.focalLength().y, camera.centre().x,
                      camera.centre().y - band.begin};
  return part;
}

void copyInto(Image& image, const Image& rows, int firstRow) {
  const std::size_t at = std::size_t(firstRow) * std::size_t(image.width);
  std::ranges::copy(rows.rgb, image.rgb.begin() + std::ptrdiff_t(3 * at));
  std::ranges::copy(rows.seen, image.seen.begin() + std::ptrdiff_t(at));
}

}  // namespace

std::vector<Band> sampledBands(int height, int step) {
  if (step == 1) return {{0, height}};
  // 010101 in binary; the remainder is near the middle of every step, which avoids the borders.
  constexpr int first = 21;
  std::vector<Band> bands;
  for (int y = first % step * bandRows; y < height; y += step * bandRows)
    bands.push_back({y, std::min(y + bandRows, height)});
  return bands;
}

int coarsestStep(int height) {
  int step = 1;
  while (step < 64 && height >= 2 * step * 4 * bandRows) step *= 2;
  return step;
}

bool isSampled(const RenderJob& job) {
  return job.method.scale == 1 && job.method.lens != LensInverse::table;
}

Image sampledPicture(const RenderJob& job, int step, Renderer& renderer, const Progress& progress) {
  if (step == 1 || !isSampled(job)) return renderer.render(job, progress);
  Image image(job.state.camera.res[0], job.state.camera.res[1]);
  for (const Band& band : sampledBands(image.height, step))
    copyInto(image, renderer.render(bandOf(job, band), progress), band.begin);
  return image;
}

Image sampledReference(const RenderJob& job, int step, const ParallelRows& parallelRows,
                       const Progress& progress) {
  const Simulation simulation(job);
  Image image(job.state.camera.res[0], job.state.camera.res[1]);
  const Progress heard = forThreads(progress);
  for (const Band& band : sampledBands(image.height, step))
    parallelRows(band.end - band.begin, [&](int begin, int end) {
      for (int y = band.begin + begin; y < band.begin + end; ++y)
        for (int x = 0; x < image.width; ++x) {
          throwIfCancelled(heard);
          simulation.render(x, y, image);
        }
    });
  return image;
}

RenderJob smaller(const RenderJob& job, int divisor) {
  RenderJob result = job;
  std::array<int, 2> res = job.state.camera.res;
  for (int& side : res) side = std::max(1, side / divisor);
  result.state = resized(job.state, res);
  return result;
}

}  // namespace hogelscope
