// SPDX-License-Identifier: BSD-3-Clause
// Traces the texels that a view reads, tile after tile.
#include "core/content/live_source.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/image.h"

namespace hogelscope {

namespace {

/// Neighbours share what they meet, so lists of texels go tile after tile.
constexpr int tile = 4;
/// Texels that are traced in one call.
constexpr std::size_t mostInList = 1024;

/// Returns point k of n of the rank-1 lattice, -1/2 … 1/2 along each axis; the middle for n = 1.
double latticeOffset(int k, int n, std::size_t axis) {
  static constexpr std::array<int, 4> generator{1, 3, 5, 7};
  return n == 1 ? 0 : (k * generator[axis] % n + 0.5) / n - 0.5;
}

/// Returns the marked texels of hogel rows [j0, j1), in tiles of hogels and of directions. Both
/// orders matter: a view reads few directions of many hogels, an export all of each.
template <class Use>
void forTexels(const SliceLayout& layout, const std::vector<std::uint8_t>& marks, int j0, int j1,
               Use use) {
  const auto& [us, vs] = layout.footprint;
  const auto inHogel = [&](int i, int j) {
    const CellRange& u = us[std::size_t(i)];
    const CellRange& v = vs[std::size_t(j)];
    const std::uint32_t start =
        layout.columnStart[std::size_t(i)] + layout.rowStart[std::size_t(j)];
    for (int v0 = v.first; v0 <= v.last; v0 += tile)
      for (int u0 = u.first; u0 <= u.last; u0 += tile)
        for (int y = v0; y <= std::min(v0 + tile - 1, v.last); ++y)
          for (int x = u0; x <= std::min(u0 + tile - 1, u.last); ++x)
            if (marks[start + std::uint32_t(y) * layout.width + std::uint32_t(x)] != 0)
              use(TexelIndex{i, j, x, y});
  };
  for (int i0 = 0; i0 < int(us.size()); i0 += tile)
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < std::min(i0 + tile, int(us.size())); ++i) inHogel(i, j);
}

template <class T>
T storedValue(double codeValue);
template <>
std::uint8_t storedValue(double codeValue) {
  return quantised(codeValue);
}
template <>
float storedValue(double codeValue) {
  return float(codeValue / 255);
}

}  // namespace

LiveSource::LiveSource(std::shared_ptr<const plugin::ContentSource> content,
                       const DisplayParams& display, const LiveParams& params, StoredType type,
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
      const double sign = axis == 1 ? -1 : 1;  // up the panel, so that ScenePattern has the same
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

/// Starts at the front of the content, so that what lies in the panel's plane is met (research on
/// rays that start there: docs/formulas.md, Live scenes).
plugin::Ray LiveSource::rayTo(const Vec3& point, double a, double b) const {
  const double z = m_front;
  return {point.x + a * (z - point.z), point.y + b * (z - point.z), z, a, b, m_front - m_back};
}

template <class T>
void LiveSource::traceTexels(std::span<const TexelIndex> list, LightField& texels) const {
  const std::size_t samples = m_samples.size();
  std::vector<plugin::Ray> rays;
  rays.reserve(list.size() * samples);
  for (const TexelIndex& at : list)
    for (const Sample& sample : m_samples)
      rays.push_back(rayTo({sample.x[std::size_t(at.i)], sample.y[std::size_t(at.j)], 0},
                           sample.a[std::size_t(at.u)], sample.b[std::size_t(at.v)]));
  std::vector<plugin::Colour> colours(rays.size());
  std::vector<float> depths(rays.size());
  m_content->trace(rays, colours, depths);
  for (std::size_t k = 0; k < list.size(); ++k) {
    std::array<double, 3> sum{};
    for (std::size_t s = k * samples; s < (k + 1) * samples; ++s) {
      sum[0] += double(colours[s].r);
      sum[1] += double(colours[s].g);
      sum[2] += double(colours[s].b);
    }
    if (!std::isfinite(sum[0] + sum[1] + sum[2]))
      throw InputError("lightField.source", "its content sends light that is not a number");
    std::array<T, 3> rgb;
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = storedValue<T>(sum[c] / double(samples));
    texels.set(list[k], rgb.data());
  }
}

template <class T>
void LiveSource::fill(const std::vector<std::uint8_t>& marks, LightField& texels,
                      const Progress& progress) const {
  const SliceLayout& layout = *texels.sliceLayout();
  const int ny = size().ny;
  const int bands = (ny + tile - 1) / tile;
  const std::size_t most = std::max(mostInList / m_samples.size(), std::size_t{1});
  const Progress polled = forThreads(progress);
  std::atomic<int> done = 0;
  m_rows(bands, [&](int begin, int end) {
    std::vector<TexelIndex> list;
    const auto flush = [&] {
      hearStop(polled);
      traceTexels<T>(list, texels);
      list.clear();
    };
    for (int band = begin; band < end; ++band) {
      forTexels(layout, marks, band * tile, std::min((band + 1) * tile, ny),
                [&](const TexelIndex& at) {
                  list.push_back(at);
                  if (list.size() == most) flush();
                });
      reportProgress(polled, double(++done) / bands);
    }
    if (!list.empty()) flush();
  });
}

std::shared_ptr<const LightField> LiveSource::slice(const ViewReads& reads,
                                                    const Progress& progress) const {
  const Footprint footprint = reads.footprint();
  if (const double bytes = double(footprint.texels()) * double(memoryBytes(m_type) + 1);
      bytes > double(m_memory))
    throw InputError("memory", "a view needs " + bytesText(std::size_t(bytes)) +
                                   " of the light field, " + bytesText(m_memory) +
                                   " are allowed: allow more");
  auto texels = std::make_shared<LightField>(size(), m_type, sliceLayout(footprint));
  std::vector<std::uint8_t> marks(texels->sliceLayout()->texels, 0);
  reads.mark(*texels->sliceLayout(), marks);
  if (m_type == StoredType::real)
    fill<float>(marks, *texels, progress);
  else
    fill<std::uint8_t>(marks, *texels, progress);
  return texels;
}

std::shared_ptr<const LightField> LiveSource::overview() const {
  std::call_once(m_overviewIsTraced, [this] {
    DisplayParams coarse = m_params;
    for (int& count : coarse.hogels) count = std::min(count, 64);
    for (int& count : coarse.directions) count = std::min(count, 16);
    const LiveSource small(m_content, coarse, m_live, m_type, m_memory, m_rows);
    const LightFieldSize size = small.size();
    m_overview =
        small.slice(readsOfRows(size, {0, size.ny - 1}, {0, size.du - 1}, {0, size.dv - 1}), {});
  });
  return m_overview;
}

void LiveSource::trace(const Vec3& eye, std::span<const Vec2> slopes, std::span<Rgb> light) const {
  std::vector<plugin::Ray> rays;
  for (const auto& [a, b] : slopes) {
    plugin::Ray ray = rayTo(eye, a, b);
    if (ray.z > eye.z) ray = {eye.x, eye.y, eye.z, a, b, eye.z - m_back};
    rays.push_back(ray);
  }
  std::vector<plugin::Colour> colours(rays.size());
  std::vector<float> depths(rays.size());
  m_content->trace(rays, colours, depths);
  for (std::size_t k = 0; k < rays.size(); ++k)
    light[k] = {double(colours[k].r), double(colours[k].g), double(colours[k].b)};
}

}  // namespace hogelscope
