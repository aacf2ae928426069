// SPDX-License-Identifier: BSD-3-Clause
// The ideal view, rendered in tiles of pixels, since neighbours meet neighbouring content.
#include "core/engine/ideal_view.h"

#include <algorithm>
#include <atomic>

#include "core/base/error.h"

namespace hogelscope {

namespace {

/// The number of pixel rows that are traced together, and of pixels of such a strip in one call.
constexpr int stripHeight = 4;
constexpr int stripWidth = batchSize;

/// Returns the number of a pixel among those of a strip.
constexpr std::size_t placeOf(int column, int row) {
  return std::size_t(row) * stripWidth + std::size_t(column);
}

const LiveScene& sceneOf(const RenderJob& job) {
  const LiveScene* const scene = job.lightField->scene();
  if (scene == nullptr) throw InputError("lightField.layout", noIdealView);
  return *scene;
}

class IdealView {
 public:
  IdealView(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
            const Progress& progress)
      : m_rays(job, tables, parallelRows, progress), m_scene(sceneOf(m_rays.job())) {}

  /// Renders pixels [x0, x1) of rows [y0, y1).
  void render(int x0, int x1, int y0, int y1, FloatImage& image) const;

 private:
  /// One ray of each of the pixels that see the display, column after column.
  struct Rays {
    std::vector<std::size_t> places;  ///< see placeOf()
    std::vector<Vec2> slopes;
  };
  [[nodiscard]] Rays raysOf(int x0, int x1, int y0, int y1, const RaySample& sample) const;

  ViewRays m_rays;
  const LiveScene& m_scene;
};

IdealView::Rays IdealView::raysOf(int x0, int x1, int y0, int y1, const RaySample& sample) const {
  std::array<LineBatch, stripHeight> rows;
  for (int y = y0; y < y1; ++y) m_rays.lines(y, x0, x1 - x0, sample, rows[std::size_t(y - y0)]);
  Rays rays;
  for (int x = x0; x < x1; ++x)
    for (int y = y0; y < y1; ++y) {
      const LineBatch& row = rows[std::size_t(y - y0)];
      if (row.seen[std::size_t(x - x0)] == 0) continue;
      rays.places.push_back(placeOf(x - x0, y - y0));
      rays.slopes.push_back(row.slopes[std::size_t(x - x0)]);
    }
  return rays;
}

void IdealView::render(int x0, int x1, int y0, int y1, FloatImage& image) const {
  const RenderJob& job = m_rays.job();
  const LightModel light = job.state.psf.light;
  std::vector<Rgb> sums(std::size_t{stripWidth} * stripHeight);
  std::vector<int> seeing(sums.size());  ///< points of the aperture that see the display
  const bool isPinhole = m_rays.plan().aperture.isPinhole;
  for (std::size_t point = 0; point < m_rays.points(); ++point) {
    std::vector<Rgb> ofPoint(sums.size());
    std::vector<std::uint8_t> seen(sums.size());
    for (const RaySample& sample : m_rays.samplesFrom(point)) {
      const Rays rays = raysOf(x0, x1, y0, y1, sample);
      std::vector<Rgb> colours(rays.slopes.size());
      m_scene.trace(m_rays.eye(point), rays.slopes, colours);
      for (std::size_t k = 0; k < colours.size(); ++k) {
        Rgb& sum = ofPoint[rays.places[k]];
        sum = sum + decoded(light, colours[k]);
        seen[rays.places[k]] = 1;
      }
    }
    const double share = 1.0 / double(m_rays.samplesFrom(point).size());
    for (std::size_t place = 0; place < sums.size(); ++place) {
      if (seen[place] == 0) continue;
      const Rgb mean = encoded(light, share * ofPoint[place]);
      sums[place] = isPinhole ? mean : sums[place] + decoded(LightModel::linear, mean);
      ++seeing[place];
    }
  }
  const auto points = static_cast<int>(m_rays.points());
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const std::size_t place = placeOf(x - x0, y - y0);
      if (seeing[place] == 0) continue;
      const std::size_t pixel = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
      const Rgb colour =
          isPinhole ? sums[place] : encoded(LightModel::linear, (1.0 / points) * sums[place]);
      image.seen[pixel] = seeing[place] == points ? 255 : 0;
      image.rgb[3 * pixel] = float(colour.r);
      image.rgb[3 * pixel + 1] = float(colour.g);
      image.rgb[3 * pixel + 2] = float(colour.b);
    }
}

}  // namespace

FloatImage renderIdeal(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                       const Progress& progress) {
  const Progress polled = forThreads(progress);
  RenderJob designed = job;
  designed.twin = nullptr;  // the scene itself has nothing to do with a unit
  const IdealView view(designed, tables, parallelRows, polled);
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
