// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/seen_texels.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/engine/hogel_pixels.h"
#include "io/files/system_limits.h"
#include "io/images/image_file.h"

namespace hogelscope {

namespace {

/// Returns a code value in the light that is summed.
std::uint16_t wishOf(double codeValue, LightModel light) {
  const double code = std::clamp(codeValue, 0.0, 255.0);
  const double part = light == LightModel::linear ? linearFromEncoded(code) : code / 255;
  return std::uint16_t(std::lround(SeenTexels::white * part));
}

}  // namespace

SeenTexels::SeenTexels(ViewSource source, std::vector<TargetView> views, std::size_t leakages,
                       LightModel light, std::size_t memory, const Progress& progress)
    : m_source(std::move(source)),
      m_views(std::move(views)),
      m_leakages(leakages),
      m_light(light),
      m_size(Display(m_source.display).size()),
      m_texels(std::uint64_t(m_size.du) * std::uint64_t(m_size.dv)) {
  chooseBands(memory, part(progress, 0, 0.3));
  std::uint64_t rays = 0, texels = 0;
  for (const Band& band : m_bands) {
    collect(band, part(progress, 0.3, 1));
    rays += m_wishes.size();
    for (std::size_t k = 0; k < m_wishes.size(); ++k)
      if (k == 0 || m_wishes[k].key / m_leakages != m_wishes[k - 1].key / m_leakages) ++texels;
  }
  m_meanWeight = texels > 0 ? double(rays) / double(texels) : 0;
}

/// Returns the state with a pixel for each of its samples.
CameraState SeenTexels::refined(const CameraState& state) const {
  CameraState result = state;
  const int each = m_source.sampling.samplesPerPixel;
  for (int& count : result.camera.res) count *= each;
  if (IntrinsicsParams& own = result.intrinsics; own.isGiven()) {
    own.fx *= each;
    own.fy *= each;
    own.cx = (own.cx + 0.5) * each - 0.5;
    own.cy = (own.cy + 0.5) * each - 0.5;
  }
  result.psf.windowSize = 1;
  return result;
}

/// Returns the picture of a view, three values a pixel; each of its pixels is `each` × `each` of
/// the refined state.
std::vector<std::uint16_t> SeenTexels::lightOf(const TargetView& view, const CameraState& refined,
                                               int& each, const Progress& progress) {
  std::vector<std::uint16_t> light;
  if (view.picture.empty()) {
    each = 1;
    const auto values = 3 * double(refined.camera.res[0]) * refined.camera.res[1];
    if (const double needed = values * double(sizeof(float) + sizeof(std::uint16_t));
        needed > double(allowedMemory()))
      throw InputError("sampling.samplesPerPixel", "the ideal view of \"" + view.state.camera.name +
                                                       "\" with all its samples "
                                                       "needs " +
                                                       bytesText(std::size_t(needed)) +
                                                       " of memory, " + bytesText(allowedMemory()) +
                                                       " are allowed: take fewer");
    light.reserve(std::size_t(values));
    RenderJob job = m_source.job(refined);
    job.sampling.samplesPerPixel = 1;
    job.isIdeal = true;
    for (const float value : m_renderer.renderFloat(job, progress).rgb)
      light.push_back(wishOf(double(value), m_light));
    return light;
  }
  each = m_source.sampling.samplesPerPixel;
  ImageFile file(view.picture);
  const auto [width, height] = view.state.camera.res;
  if (file.width() != std::size_t(width) || file.height() != std::size_t(height))
    throw InputError(view.picture.string(), "has " +
                                                pairText(long(file.width()), long(file.height())) +
                                                " pixels; the state \"" + view.state.camera.name +
                                                "\" has " + pairText(width, height));
  light.reserve(3 * file.width() * file.height());
  file.readRows(
      [&](std::size_t, const float* rgb) {
        for (int k = 0; k < 3 * width; ++k) light.push_back(wishOf(255 * double(rgb[k]), m_light));
      },
      progress);
  return light;
}

/// Calls `use` with batches of the rays of a view, from several threads: row, first column, count
/// and the cells that they meet.
template <class Use>
void SeenTexels::eachRay(const CameraState& refined, const Use& use, const Progress& progress) {
  RenderJob job = m_source.job(refined);
  job.sampling.samplesPerPixel = 1;
  const ViewRays rays(middleRays(job), m_renderer.tables(), parallelRows, progress);
  const auto [width, height] = refined.camera.res;
  parallelRows(height, [&, width = width](int begin, int end) {
    CellBatch batch;
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < width; x += batchSize) {
        const int count = std::min(batchSize, width - x);
        rays.cells(y, x, count, {}, batch);
        use(y, x, count, batch);
      }
  });
}

/// Chooses rows of hogels whose wishes fit into the memory together.
void SeenTexels::chooseBands(std::size_t memory, const Progress& progress) {
  const double each = m_source.sampling.samplesPerPixel;
  double most = 0;
  for (const TargetView& view : m_views)
    most += each * each * view.state.camera.res[0] * view.state.camera.res[1];
  if (most * double(sizeof(Wish)) <= double(memory)) {
    m_bands = {{0, m_size.ny}};
    return;
  }
  std::vector<std::uint64_t> rays(std::size_t(m_size.ny));
  std::mutex mutex;
  for (std::size_t k = 0; k < m_views.size(); ++k) {
    reportProgress(progress, double(k) / double(m_views.size()));
    eachRay(
        refined(m_views[k].state),
        [&](int, int, int count, const CellBatch& batch) {
          const std::lock_guard lock(mutex);
          for (int n = 0; n < count; ++n)
            if (batch.seen[std::size_t(n)] != 0) ++rays[batch.cell[1][std::size_t(n)]];
        },
        progress);
  }
  std::uint64_t inBand = 0;
  for (int j = 0; j < m_size.ny; ++j) {
    inBand += rays[std::size_t(j)];
    if (m_bands.empty() || inBand * sizeof(Wish) > memory) {
      m_bands.push_back({j, j});
      inBand = rays[std::size_t(j)];
    }
    m_bands.back().last = j + 1;
  }
}

void SeenTexels::collect(const Band& band, const Progress& progress) {
  m_wishes.clear();
  std::mutex mutex;
  for (std::size_t k = 0; k < m_views.size(); ++k) {
    const TargetView& view = m_views[k];
    const Progress own =
        part(progress, double(k) / double(m_views.size()), double(k + 1) / double(m_views.size()));
    const CameraState rays = refined(view.state);
    int each = 1;
    const std::vector<std::uint16_t> light = lightOf(view, rays, each, own);
    const auto width = std::size_t(rays.camera.res[0] / each);
    eachRay(
        rays,
        [&](int y, int x0, int count, const CellBatch& batch) {
          std::vector<Wish> wishes;
          for (int n = 0; n < count; ++n) {
            const auto at = std::size_t(n);
            const std::uint64_t j = batch.cell[1][at];
            if (batch.seen[at] == 0 || int(j) < band.first || int(j) >= band.last) continue;
            const std::uint64_t hogel = j * std::uint64_t(m_size.nx) + batch.cell[0][at];
            const std::uint64_t texel =
                std::uint64_t(batch.cell[3][at]) * std::uint64_t(m_size.du) + batch.cell[2][at];
            const std::uint16_t* const p =
                &light[3 * (std::size_t(y / each) * width + std::size_t((x0 + n) / each))];
            wishes.push_back(
                {(hogel * m_texels + texel) * m_leakages + view.leakage, {p[0], p[1], p[2]}});
          }
          const std::lock_guard lock(mutex);
          m_wishes.insert(m_wishes.end(), wishes.begin(), wishes.end());
        },
        own);
  }
  std::ranges::sort(m_wishes, {}, &Wish::key);
  m_loaded = band;
}

void SeenTexels::load(int j, const Progress& progress) {
  if (j >= m_loaded.first && j < m_loaded.last) return;
  collect(*std::ranges::find_if(m_bands, [&](const Band& band) { return j < band.last; }),
          progress);
}

std::span<const SeenTexels::Wish> SeenTexels::of(int i, int j) const {
  const std::uint64_t hogel = std::uint64_t(j) * std::uint64_t(m_size.nx) + std::uint64_t(i);
  const std::uint64_t perHogel = m_texels * m_leakages;
  const auto first = std::ranges::lower_bound(m_wishes, hogel * perHogel, {}, &Wish::key);
  const auto last =
      std::ranges::lower_bound(first, m_wishes.end(), (hogel + 1) * perHogel, {}, &Wish::key);
  return {first, last};
}

}  // namespace hogelscope
