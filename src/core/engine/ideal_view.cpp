// SPDX-License-Identifier: BSD-3-Clause
// The ideal view, rendered in tiles of pixels, since neighbours meet neighbouring content.
#include "core/engine/ideal_view.h"

#include <algorithm>
#include <atomic>

namespace hogelscope {

namespace {

/// The number of pixel rows that are traced together, and of pixels of such a strip in one call.
constexpr int stripHeight = 4;
constexpr int stripWidth = batchSize;

class IdealView {
 public:
  IdealView(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
            const Progress& progress)
      : m_rays(job, tables, parallelRows, progress) {}

  /// Renders pixels [x0, x1) of rows [y0, y1).
  void render(int x0, int x1, int y0, int y1, FloatImage& image) const;

 private:
  /// One ray of each of the pixels that see the display, column after column.
  struct Rays {
    std::vector<std::size_t> pixels;
    std::vector<Vec2> slopes;
  };
  [[nodiscard]] Rays raysOf(int x0, int x1, int y0, int y1, const RaySample& sample) const;

  ViewRays m_rays;
};

IdealView::Rays IdealView::raysOf(int x0, int x1, int y0, int y1, const RaySample& sample) const {
  const RenderJob& job = m_rays.job();
  std::array<LineBatch, stripHeight> rows;
  for (int y = y0; y < y1; ++y) m_rays.lines(y, x0, x1 - x0, sample, rows[std::size_t(y - y0)]);
  Rays rays;
  for (int x = x0; x < x1; ++x)
    for (int y = y0; y < y1; ++y) {
      const LineBatch& row = rows[std::size_t(y - y0)];
      if (row.seen[std::size_t(x - x0)] == 0) continue;
      rays.pixels.push_back(std::size_t(y) * std::size_t(job.state.camera.res[0]) + std::size_t(x));
      rays.slopes.push_back(row.slopes[std::size_t(x - x0)]);
    }
  return rays;
}

void IdealView::render(int x0, int x1, int y0, int y1, FloatImage& image) const {
  const RenderJob& job = m_rays.job();
  const LightModel light = job.state.psf.light;
  std::vector<Rgb> sums(std::size_t(x1 - x0) * stripHeight);
  const auto sumOf = [&](std::size_t pixel) -> Rgb& {
    const auto width = std::size_t(image.width);
    return sums[(pixel / width - std::size_t(y0)) * std::size_t(x1 - x0) + pixel % width -
                std::size_t(x0)];
  };
  for (const RaySample& sample : m_rays.samples()) {
    const Rays rays = raysOf(x0, x1, y0, y1, sample);
    std::vector<Rgb> colours(rays.slopes.size());
    job.lightField->trace(m_rays.eye(), rays.slopes, colours);
    for (std::size_t k = 0; k < colours.size(); ++k) {
      Rgb& sum = sumOf(rays.pixels[k]);
      sum = sum + decoded(light, colours[k]);
      image.seen[rays.pixels[k]] = 255;
    }
  }
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const std::size_t pixel = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
      if (image.seen[pixel] == 0) continue;
      const Rgb colour = encoded(light, (1.0 / double(m_rays.samples().size())) * sumOf(pixel));
      image.rgb[3 * pixel] = float(colour.r);
      image.rgb[3 * pixel + 1] = float(colour.g);
      image.rgb[3 * pixel + 2] = float(colour.b);
    }
}

}  // namespace

FloatImage renderIdeal(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                       const Progress& progress) {
  const Progress polled = forThreads(progress);
  const IdealView view(job, tables, parallelRows, polled);
  const auto [width, height] = job.state.camera.res;
  FloatImage image(width, height);
  const int strips = (height + stripHeight - 1) / stripHeight;
  std::atomic<int> done = 0;
  parallelRows(strips, [&, width = width, height = height](int begin, int end) {
    for (int strip = begin; strip < end; ++strip) {
      const int y0 = strip * stripHeight;
      for (int x = 0; x < width; x += stripWidth)
        view.render(x, std::min(x + stripWidth, width), y0, std::min(y0 + stripHeight, height),
                    image);
      reportProgress(polled, double(++done) / strips);
    }
  });
  return image;
}

}  // namespace hogelscope
