// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/live_source.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <tuple>

#include "core/base/error.h"
#include "core/base/multiversioned.h"
#include "core/content/lattice.h"
#include "core/optics/image.h"

namespace hogelscope {

namespace {

/// The side of a tile. Neighbours meet the same content, so lists of texels go tile after tile.
constexpr int tile = 4;
/// The most texels that are traced in one call.
constexpr std::size_t mostInList = 512;

/// Rounds as quantised() does, without branches or a wider type, so that it is vectorised. The
/// difference of a number and its whole part is exact.
template <class Number>
MULTIVERSIONED void quantise(const Number* values, std::size_t count, std::uint8_t* to) {
  for (std::size_t k = 0; k < count; ++k) {
    const Number value = values[k] > 0 ? std::min(values[k], Number(255)) : 0;
    const int whole = int(value);
    to[k] = std::uint8_t(whole + int(value - Number(whole) >= Number(0.5)));
  }
}

template <class Number>
void store(const Number* values, std::size_t count, std::uint8_t* to) {
  quantise(values, count, to);
}
template <class Number>
void store(const Number* values, std::size_t count, float* to) {
  for (std::size_t k = 0; k < count; ++k) to[k] = float(double(values[k]) / 255);
}

/// Whether all values are finite. It checks the exponents without branches, so that it is
/// vectorised.
MULTIVERSIONED bool areFinite(const float* values, std::size_t count) {
  constexpr std::uint32_t exponent = 0x7f800000;
  std::uint32_t bad = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto bits = std::bit_cast<std::uint32_t>(values[k]);
    bad |= std::uint32_t((bits & exponent) == exponent);
  }
  return bad == 0;
}

void requireFinite(const std::vector<plugin::Colour>& colours) {
  if (colours.empty()) return;
  static_assert(sizeof(plugin::Colour) == 3 * sizeof(float));
  if (!areFinite(&colours.data()->r, 3 * colours.size()))
    throw InputError("lightField.source", "its content sends light that is not a number");
}

}  // namespace

LiveSource::LiveSource(std::shared_ptr<const plugin::ContentSource> content,
                       const PanelParams& display, const LiveParams& params, StoredType type,
                       std::size_t memory, ParallelRows rows)
    : m_content(std::move(content)),
      m_params(display),
      m_live(params),
      m_display(display),
      m_type(type),
      m_memory(memory),
      m_rows(std::move(rows)) {
  m_content->depths(m_back, m_front);
  const double margin = 0.01 * (m_front - m_back) + 1e-6;
  m_back = std::max(m_back - margin, params.depth[0]);
  m_front = std::min(m_front + margin, params.depth[1]);
  const auto [nx, ny, du, dv] = m_display.size();
  for (int k = 0; k < params.samples; ++k) {
    const auto offset = [&](std::size_t axis) {
      const double sign = axis == 1 ? -1 : 1;  // up the panel, as in ScenePattern
      return 0.5 + sign * params.fill[axis / 2] * latticeOffset(k, params.samples, axis);
    };
    Sample sample;
    for (int i = 0; i < nx; ++i) sample.x.push_back(m_display.position(i + offset(0), 0).x);
    for (int j = 0; j < ny; ++j) sample.y.push_back(m_display.position(0, j + offset(1)).y);
    for (int u = 0; u < du; ++u) sample.a.push_back(m_display.slopes(u + offset(2), 0).x);
    for (int v = 0; v < dv; ++v) sample.b.push_back(m_display.slopes(0, v + offset(3)).y);
    m_samples.push_back(std::move(sample));
  }
}

std::array<double, 2> LiveSource::depths() const {
  double back = 0;
  double front = 0;
  m_content->depths(back, front);
  return {std::max(back, m_live.depth[0]), std::min(front, m_live.depth[1])};
}

/// The texels to be traced, and memory for their light.
struct LiveSource::Work {
  std::vector<std::uint32_t> addresses;
  std::vector<plugin::Ray> rays;  ///< all samples of a texel, texel after texel
  std::vector<plugin::Colour> colours;
  std::vector<double> means;
};

/// Traces the first texels of the work, and stores the means of the samples.
template <class T>
void LiveSource::traceTexels(Work& work, std::size_t texelCount, LightField& texels) const {
  auto& [addresses, rays, colours, means] = work;
  const std::size_t rayCount = texelCount * m_samples.size();
  colours.resize(rayCount);
  m_content->trace(std::span(rays).first(rayCount), colours);
  requireFinite(colours);
  const float* light = &colours.data()->r;
  const std::size_t count = 3 * texelCount;
  std::array<T, 3 * mostInList> stored;
  if (m_samples.size() == 1) {
    store(light, count, stored.data());
  } else {
    means.assign(count, 0);
    for (double* mean = means.data(); mean < means.data() + count; mean += 3)
      for (std::size_t s = 0; s < m_samples.size(); ++s)
        for (std::size_t c = 0; c < 3; ++c) mean[c] += double(*light++);
    for (double& mean : means) mean *= 1.0 / double(m_samples.size());
    store(means.data(), count, stored.data());
  }
  const T* from = stored.data();
  for (std::size_t k = 0; k < texelCount; ++k, from += 3) texels.setAddress(addresses[k], from);
}

/// Calls `use` with the directions of a hogel, in tiles of directions, since neighbours meet the
/// same content.
template <class Use>
inline void forDirections(const CellRange& u, const CellRange& v, Use use) {
  const auto inTile = [&](int u0, int u1, int v0, int v1) {
    for (int y = v0; y <= v1; ++y)
      for (int x = u0; x <= u1; ++x) use(x, y);
  };
  if (u.last - u.first < tile && v.last - v.first < tile)  // most hogels of a view without leakage
    return inTile(u.first, u.last, v.first, v.last);
  for (int v0 = v.first; v0 <= v.last; v0 += tile)
    for (int u0 = u.first; u0 <= u.last; u0 += tile)
      inTile(u0, std::min(u0 + tile - 1, u.last), v0, std::min(v0 + tile - 1, v.last));
}

/// Traces the texels of hogel rows [j0, j1) that are marked, or all where `marks` is empty, in
/// tiles of hogels: a view reads few directions of many hogels.
template <class T>
void LiveSource::fillRows(int j0, int j1, const std::vector<std::uint8_t>& marks, Work& work,
                          LightField& texels, const Progress& progress) const {
  const SliceLayout& layout = *texels.sliceLayout();
  const std::size_t most = std::max(mostInList / m_samples.size(), std::size_t{1});
  const std::uint8_t* const mark = marks.empty() ? nullptr : marks.data();
  const double z = m_front;  // not the panel's plane, where rounding decides whether content is met
  const double reach =
      std::max(m_front - m_back, 0.0);  // the difference is below 0 if all content is cut
  work.addresses.resize(most);
  work.rays.resize(most * m_samples.size());
  std::size_t waiting = 0;
  const auto trace = [&] {
    throwIfCancelled(progress);
    traceTexels<T>(work, waiting, texels);
    waiting = 0;
  };
  const auto addHogel = [&](int i, int j) {
    const std::uint32_t start =
        layout.columnStart[std::size_t(i)] + layout.rowStart[std::size_t(j)];
    forDirections(
        layout.footprint.u[std::size_t(i)], layout.footprint.v[std::size_t(j)], [&](int u, int v) {
          const std::uint32_t address = start + std::uint32_t(v) * layout.width + std::uint32_t(u);
          if (mark != nullptr && mark[address] == 0) return;
          work.addresses[waiting] = address;
          plugin::Ray* ray = &work.rays[waiting * m_samples.size()];
          for (const auto& [xs, ys, as, bs] : m_samples) {
            const double x = xs[std::size_t(i)];
            const double y = ys[std::size_t(j)];
            const Vec2 turn = m_display.turn({x, y});
            const double a = as[std::size_t(u)] - turn.x;
            const double b = bs[std::size_t(v)] - turn.y;
            *ray++ = {x + a * z, y + b * z, z, a, b, reach};
          }
          if (++waiting == most) trace();
        });
  };
  const int nx = size().nx;
  for (int i0 = 0; i0 < nx; i0 += tile)
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < std::min(i0 + tile, nx); ++i) addHogel(i, j);
  if (waiting > 0) trace();
}

template <class T>
void LiveSource::fill(const std::vector<std::uint8_t>& marks, LightField& texels,
                      const Progress& progress) const {
  const int ny = size().ny;
  const int bands = (ny + tile - 1) / tile;
  const Progress polled = forThreads(progress);
  std::atomic<int> done = 0;
  m_rows(bands, [&](int begin, int end) {
    Work work;
    for (int band = begin; band < end; ++band) {
      fillRows<T>(band * tile, std::min((band + 1) * tile, ny), marks, work, texels, polled);
      reportProgress(polled, double(++done) / bands);
    }
  });
}

std::shared_ptr<const LightField> LiveSource::slice(const ViewReads& reads,
                                                    const Progress& progress) const {
  const Footprint footprint = reads.footprint();
  requireMemory(footprint, memoryBytes(m_type) + 1, m_memory);  // and a mark
  auto texels = std::make_shared<LightField>(size(), m_type, sliceLayout(footprint));
  std::vector<std::uint8_t> marks;
  if (reads.mark) {
    marks.resize(texels->sliceLayout()->texels);
    reads.mark(*texels->sliceLayout(), marks);
  }
  if (m_type == StoredType::real)
    fill<float>(marks, *texels, progress);
  else
    fill<std::uint8_t>(marks, *texels, progress);
  return texels;
}

std::shared_ptr<const LightField> LiveSource::overview() const {
  std::call_once(m_overviewIsTraced, [this] {
    PanelParams coarse = m_params;
    for (int& count : coarse.hogels) count = std::min(count, 64);
    for (int& count : coarse.directions) count = std::min(count, 16);
    LiveParams quick = m_live;
    quick.samples = 1;
    const LiveSource small(m_content, coarse, quick, m_type, m_memory, m_rows);
    const LightFieldSize size = small.size();
    m_overview =
        small.slice(readsOfRows(size, {0, size.ny - 1}, {0, size.du - 1}, {0, size.dv - 1}), {});
  });
  return m_overview;
}

std::vector<plugin::Ray> LiveSource::raysFrom(const Vec3& eye, std::span<const Vec2> slopes) const {
  std::vector<plugin::Ray> rays;
  rays.reserve(slopes.size());
  const double z = std::min(m_front, eye.z);
  for (const auto& [a, b] : slopes)
    rays.push_back(
        {eye.x + a * (z - eye.z), eye.y + b * (z - eye.z), z, a, b, std::max(z - m_back, 0.0)});
  return rays;
}

void LiveSource::traceAll(std::span<const plugin::Ray> rays, std::span<Rgb> light) const {
  std::vector<plugin::Colour> colours(rays.size());
  m_content->trace(rays, colours);
  requireFinite(colours);
  for (std::size_t k = 0; k < rays.size(); ++k)
    light[k] = {double(colours[k].r), double(colours[k].g), double(colours[k].b)};
}

void LiveSource::trace(const Vec3& eye, std::span<const Vec2> slopes, std::span<Rgb> light) const {
  traceAll(raysFrom(eye, slopes), light);
}

void LiveSource::traceRays(std::span<const PanelRay> panelRays, std::span<Rgb> light) const {
  std::vector<plugin::Ray> rays;
  rays.reserve(panelRays.size());
  const double z = m_front;
  for (const auto& [at, slopes] : panelRays)
    rays.push_back({at.x + slopes.x * z, at.y + slopes.y * z, z, slopes.x, slopes.y,
                    std::max(m_front - m_back, 0.0)});
  traceAll(rays, light);
}

void LiveSource::traceDepths(const Vec3& eye, std::span<const Vec2> slopes,
                             std::span<double> depths) const {
  std::vector<plugin::Ray> rays = raysFrom(eye, slopes);
  if (!m_content->traceDepths(rays, depths)) bisectDepths(std::move(rays), depths);
}

/// Halves for each ray the range of depths at which the light becomes that of the whole ray.
void LiveSource::bisectDepths(std::vector<plugin::Ray> rays, std::span<double> depths) const {
  constexpr int halvings = 10;  // 2^10 depths
  const auto lightAt = [&] {
    std::vector<plugin::Colour> colours(rays.size());
    m_content->trace(rays, colours);
    requireFinite(colours);
    return colours;
  };
  const std::vector<plugin::Colour> whole = lightAt();
  std::vector<double> near(rays.size()), far(rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) far[k] = rays[k].reach;
  const auto isWhole = [&](const plugin::Colour& colour, std::size_t k) {
    return std::tie(colour.r, colour.g, colour.b) == std::tie(whole[k].r, whole[k].g, whole[k].b);
  };
  for (plugin::Ray& ray : rays) ray.reach = 0;
  const std::vector<plugin::Colour> background = lightAt();
  for (int halving = 0; halving < halvings; ++halving) {
    for (std::size_t k = 0; k < rays.size(); ++k) rays[k].reach = (near[k] + far[k]) / 2;
    const std::vector<plugin::Colour> colours = lightAt();
    for (std::size_t k = 0; k < rays.size(); ++k)
      (isWhole(colours[k], k) ? far : near)[k] = rays[k].reach;
  }
  for (std::size_t k = 0; k < rays.size(); ++k)
    depths[k] = isWhole(background[k], k) ? std::numeric_limits<double>::quiet_NaN()
                                          : rays[k].z - (near[k] + far[k]) / 2;
}

}  // namespace hogelscope
