// SPDX-License-Identifier: BSD-3-Clause
// The fast engine: rays in batches, their addresses one batch ahead of their texels.
#include "core/engine/fast_simulation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>

#include "core/base/error.h"
#include "core/engine/view_footprint.h"

namespace hogelscope {

namespace {

HitMap hitMapOf(const DisplayParams& params, const Display& display, const Camera& camera) {
  const RigidTransform& world = camera.worldFromCamera();
  const RigidTransform& displayFromWorld = display.displayFromWorld();
  const auto list = [](const Vec3& d) { return std::array{d.x, d.y, d.z}; };
  const Vec3 eye = displayFromWorld.point(world.origin);
  const auto [nx, ny, du, dv] = display.size();
  const double fieldX = 2 * std::tan(radians(params.fov[0]) / 2);
  const double fieldY = 2 * std::tan(radians(params.fov[1]) / 2);
  HitMap map;
  map.right = list(displayFromWorld.direction(world.xAxis));
  map.down = list(displayFromWorld.direction(world.yAxis));
  map.forward = list(displayFromWorld.direction(world.zAxis));
  map.count = {nx, ny, du, dv};
  map.constant = {(eye.x / params.size[0] + 0.5) * nx, (0.5 - eye.y / params.size[1]) * ny,
                  0.5 * du, 0.5 * dv};
  map.slope = {-eye.z / params.size[0] * nx, eye.z / params.size[1] * ny, du / fieldX,
               -dv / fieldY};
  return map;
}

/// The part of [low, high] where constant + slope·x ≥ 0.
void clip(double constant, double slope, std::array<double, 2>& part) {
  if (slope > 0)
    part[0] = std::max(part[0], -constant / slope);
  else if (slope < 0)
    part[1] = std::min(part[1], -constant / slope);
  else if (constant < 0)
    part = {1, 0};
}

}  // namespace

struct FastSimulation::Scratch {
  CellBatch cells{};
  TexelFilter::Scratch taps;
  LightBatch sum{};
};

FastSimulation::FastSimulation(const View& view, LensTables& tables,
                               const ParallelRows& parallelRows, const Progress& progress)
    : m_view(view), m_progress(forThreads(progress)) {
  const Simulation valid(view);  // throws what is wrong
  m_plan = hogelscope::plan(view);
  m_lensKey = lensKeyOf(view.state, view.sampling, view.method);
  const Display display(view.display);
  m_map = hitMapOf(view.display, display, Camera(view.state.camera, view.state.intrinsics));
  m_map.isSingle = view.method.isSingle;
  m_seesNothing = !(display.displayFromWorld().point(view.state.camera.eye).z > 0);
  for (int x = 0; x < view.state.camera.res[0]; ++x)
    m_x.push_back((x - m_lensKey.centre.x) / m_lensKey.focalLength.x);
  if (m_plan.isTableKept && !m_seesNothing)
    m_lens = tables.get(m_lensKey, parallelRows, m_progress);
  if (!m_lens) m_rays.emplace(m_lensKey, m_progress);
  if (view.lightField->store() != nullptr) fetch(parallelRows);
  m_unseen = m_view.lightField->layout().texels;
  m_taps.emplace(m_view, m_plan);
}

void FastSimulation::fetch(const ParallelRows& parallelRows) {
  const auto [width, height] = m_view.state.camera.res;
  Footprint all = m_view.lightField->slice()->footprint;
  std::mutex mutex;
  parallelRows(height, [&, width = width](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const Footprint ofRow = footprint(*this, m_view, y, 0, width);
      const std::lock_guard lock(mutex);
      all.include(ofRow);
    }
  });
  m_view.lightField = m_view.lightField->store()->slice(all, part(m_progress, 0, 0));
}

/// The columns of a row whose rays hit, for a plain lens: each condition of a hit is linear in x
/// once it is multiplied by the direction's z.
std::array<int, 2> FastSimulation::seenPart(int y, int x0, int x1) const {
  const double py = (y - m_lensKey.centre.y) / m_lensKey.focalLength.y;
  const auto at = [&](std::size_t c) { return m_map.down[c] * py + m_map.forward[c]; };
  std::array<double, 2> part{m_x[std::size_t(x0)], m_x[std::size_t(x1 - 1)]};
  clip(-at(2), -m_map.right[2], part);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::size_t c = axis % 2;
    for (const auto& [border, sign] : {std::pair{0, -1.0}, std::pair{m_map.count[axis], 1.0}}) {
      const double constant = m_map.constant[axis] - border;
      clip(sign * (constant * at(2) + m_map.slope[axis] * at(c)),
           sign * (constant * m_map.right[2] + m_map.slope[axis] * m_map.right[c]), part);
    }
  }
  if (!(part[0] <= part[1])) return {x0, x0};
  const auto column = [&](double x) { return x * m_lensKey.focalLength.x + m_lensKey.centre.x; };
  int first = std::max(x0, static_cast<int>(std::ceil(column(part[0]))) - 1);
  int last = std::min(x1, static_cast<int>(std::floor(column(part[1]))) + 2);
  // The ends are decided by the ray itself, not by the rounding of the division above.
  const auto isUnseen = [&](int x) {
    CellBatch batch;
    hogelscope::cells(m_map, &m_x[std::size_t(x)], &py, 1, batch);
    return batch.seen[0] == 0;
  };
  while (first < last && isUnseen(first)) ++first;
  while (first < last && isUnseen(last - 1)) --last;
  return {first, last};
}

std::int64_t FastSimulation::rays() const {
  const auto [width, height] = m_view.state.camera.res;
  const std::int64_t n = m_view.sampling.samplesPerPixel;
  if (m_seesNothing) return 0;
  if (!m_plan.knowsOutline) return n * n * width * height;
  std::int64_t count = 0;
  for (int y = 0; y < height; ++y) {
    const auto [first, last] = seenPart(y, 0, width);
    count += last - first;
  }
  return count;
}

void FastSimulation::row(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  hearStop(m_progress);
  const auto count = std::size_t(x1 - x0);
  std::memset(rgb, 0, 3 * count);
  std::memset(seen, 0, count);
  if (m_seesNothing) return;
  if (m_plan.copiesTexels && m_plan.knowsOutline) return copyPlainRow(y, x0, x1, rgb, seen);
  if (m_plan.copiesTexels && m_lens && m_view.display.lens == HogelLens::rectilinear)
    return copyRow(y, x0, x1, rgb, seen);
  std::vector<float> sums(3 * count);
  sumRow(y, x0, x1, sums.data(), seen);
  for (std::size_t k = 0; k < sums.size(); ++k) rgb[k] = quantised(double(sums[k]));
}

void FastSimulation::row(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const auto count = std::size_t(x1 - x0);
  std::fill(rgb, rgb + 3 * count, 0.0F);
  std::memset(seen, 0, count);
  if (!m_seesNothing) sumRow(y, x0, x1, rgb, seen);
}

namespace {

using ByteTexel = Texel<std::uint8_t>;

/// While a batch's texels come from memory the next batch's addresses are worked out.
template <class AddressesOf, class Take>
void inBatches(int begin, int end, const ByteTexel* texels, AddressesOf addressesOf, Take take) {
  std::array<std::array<std::uint32_t, batchSize>, 2> address;
  std::array<ByteTexel, batchSize> found;
  int previous = begin;
  std::size_t turn = 0;
  for (int x = begin; previous < end; x += batchSize, turn = 1 - turn) {
    const int count = std::min(batchSize, end - x);
    if (count > 0) {
      addressesOf(x, count, address[turn].data());
      prefetch(texels, address[turn].data(), count);
    }
    if (x == begin) continue;
    const int before = std::min(batchSize, end - previous);
    gather(texels, address[1 - turn].data(), before, found.data());
    take(previous, before, address[1 - turn].data(), found.data());
    previous += before;
  }
}

}  // namespace

void FastSimulation::copyPlainRow(int y, int x0, int x1, std::uint8_t* rgb,
                                  std::uint8_t* seen) const {
  const auto [first, last] = seenPart(y, x0, x1);
  const double py = (y - m_lensKey.centre.y) / m_lensKey.focalLength.y;
  const BlockLayout& layout = m_view.lightField->layout();
  std::memset(seen + (first - x0), 255, std::size_t(last - first));
  inBatches(
      first, last, std::get<TexelArray<std::uint8_t>>(m_view.lightField->texels()).data(),
      [&](int x, int count, std::uint32_t* address) {
        addressesOfHits(m_map, layout, &m_x[std::size_t(x)], py, count, address);
      },
      [&](int x, int count, const std::uint32_t*, const ByteTexel* found) {
        pack(found, count, rgb + std::ptrdiff_t(3) * (x - x0));
      });
}

void FastSimulation::copyRow(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const {
  const BlockLayout& layout = m_view.lightField->layout();
  const double* px = m_lens->x(y, 0, 0);
  const double* py = m_lens->y(y, 0, 0);
  inBatches(
      x0, x1, std::get<TexelArray<std::uint8_t>>(m_view.lightField->texels()).data(),
      [&](int x, int count, std::uint32_t* address) {
        addresses(m_map, layout, px + x, py + x, count, m_unseen, address);
      },
      [&](int x, int count, const std::uint32_t* address, const ByteTexel* found) {
        pack(found, count, rgb + std::ptrdiff_t(3) * (x - x0));
        mask(address, count, m_unseen, seen + (x - x0));
      });
}

namespace {

/// Lanes without a hit get the cells of one with a hit, so that whole batches stay away from
/// borders. False if there is none.
bool fillUnseen(int count, CellBatch& batch) {
  const auto end = batch.seen.begin() + count;
  const auto hit = std::find(batch.seen.begin(), end, std::uint8_t{255});
  if (hit == end) return false;
  std::fill(end, batch.seen.end(), std::uint8_t{0});
  const auto at = std::size_t(hit - batch.seen.begin());
  for (auto& cell : batch.cell)
    for (std::size_t k = 0; k < batchSize; ++k) cell[k] = batch.seen[k] == 0 ? cell[at] : cell[k];
  return true;
}

}  // namespace

void FastSimulation::cells(int y, int x0, int count, int sx, int sy, CellBatch& batch) const {
  hearStop(m_progress);
  if (m_seesNothing) {
    std::fill_n(batch.seen.begin(), count, std::uint8_t{0});
    return;
  }
  std::array<double, batchSize> madeX;
  std::array<double, batchSize> madeY;
  const double* x = madeX.data();
  const double* py = madeY.data();
  if (m_lens) {
    x = m_lens->x(y, sx, sy) + x0;
    py = m_lens->y(y, sx, sy) + x0;
  } else if (!m_plan.hasLens && m_lensKey.samplesPerPixel == 1) {
    x = &m_x[std::size_t(x0)];
    madeY.fill((y - m_lensKey.centre.y) / m_lensKey.focalLength.y);
  } else {
    m_rays->row(y, sx, sy, x0, count, madeX.data(), madeY.data());
  }
  if (m_view.display.lens == HogelLens::equiangular)
    equiangularCells(m_map, {radians(m_view.display.fov[0]), radians(m_view.display.fov[1])}, x, py,
                     count, batch);
  else
    hogelscope::cells(m_map, x, py, count, batch);
}

/// Cells of the rays of `count` pixels from x0 on. False if none of them hits.
bool FastSimulation::castRays(int y, int x0, int count, int sx, int sy, Scratch& scratch) const {
  cells(y, x0, count, sx, sy, scratch.cells);
  return fillUnseen(count, scratch.cells);
}

void FastSimulation::sumRow(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const {
  const auto [begin, end] = m_plan.knowsOutline ? seenPart(y, x0, x1) : std::array{x0, x1};
  const auto scratch = std::make_unique<Scratch>();
  const int n = m_view.sampling.samplesPerPixel;
  const float share = 1 / static_cast<float>(n * n);
  for (int first = begin; first < end; first += batchSize) {
    const int count = std::min(batchSize, end - first);
    for (int s = 0; s < n * n; ++s) {
      if (!castRays(y, first, count, s % n, s / n, *scratch)) continue;
      m_taps->sum(count, scratch->cells, scratch->taps, scratch->sum);
      for (int k = 0; k < count; ++k) {
        const auto ray = std::size_t(k);
        if (scratch->cells.seen[ray] == 0) continue;
        const auto pixel = std::size_t(first - x0) + ray;
        seen[pixel] = 255;
        rgb[3 * pixel] += share * scratch->sum.r[ray];
        rgb[3 * pixel + 1] += share * scratch->sum.g[ray];
        rgb[3 * pixel + 2] += share * scratch->sum.b[ray];
      }
    }
  }
  if (!m_plan.sumsLinear) return;
  for (int k = 0; k < 3 * (x1 - x0); ++k)
    rgb[k] = static_cast<float>(encodedFromLinear(double(rgb[k])));
}

Image simulateFast(const View& view, LensTables& tables, const ParallelRows& parallelRows,
                   const Progress& progress) {
  const Progress heard = forThreads(progress);
  const FastSimulation simulation(view, tables, parallelRows, heard);
  const auto [width, height] = view.state.camera.res;
  Image image(width, height);
  std::atomic<int> done = 0;
  parallelRows(height, [&, width = width, height = height](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::size_t first = std::size_t(y) * std::size_t(width);
      simulation.row(y, 0, width, &image.rgb[3 * first], &image.seen[first]);
      advance(heard, double(++done) / height);
    }
  });
  return image;
}

Image simulateFast(const View& view) {
  LensTables tables;
  return simulateFast(view, tables);
}

}  // namespace hogelscope
