// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/view_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/panel/twin.h"

namespace hogelscope {

namespace {

HitMap hitMapOf(const RigidTransform& displayFromCamera, const Display& display) {
  const auto list = [](const Vec3& d) { return std::array{d.x, d.y, d.z}; };
  HitMap map;
  map.right = list(displayFromCamera.xAxis);
  map.down = list(displayFromCamera.yAxis);
  map.forward = list(displayFromCamera.zAxis);
  map.panel = display.mapFrom(displayFromCamera.origin);
  map.finder = finderOf(display);
  return map;
}

ApertureMiddle middleOf(const RigidTransform& displayFromCamera, const Display& display) {
  const Vec3 eye = displayFromCamera.origin;
  ApertureMiddle middle{hitMapOf(displayFromCamera, display), eye, {}};
  const PanelMap beside = display.mapFrom(eye + Vec3{1, 1, 0});
  for (std::size_t axis = 0; axis < 4; ++axis)
    middle.perMetre[axis] = beside.constant[axis] - middle.map.panel.constant[axis];
  return middle;
}

/// The numbers of cells on each side of a ray's cell that the ray may also read.
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

/// Returns the cells that a ray reads along an axis: its own, the neighbour that is interpolated
/// with or that float arithmetic finds in its place (`border` of a cell), and `reach` more on each
/// side.
CellRange cellsRead(std::uint32_t cell, float place, bool isInterpolated, float border, int reach,
                    int count) {
  const int own = int(cell);
  const int neighbour = isInterpolated       ? (place < 0.5F ? own - 1 : own + 1)
                        : place < border     ? own - 1
                        : place > 1 - border ? own + 1
                                             : own;
  return {std::max(std::min(own, neighbour) - reach, 0),
          std::min(std::max(own, neighbour) + reach, count - 1)};
}

/// Sets the marks of a box's texels. Several threads may set the same mark, all to 1.
void markBox(const std::array<CellRange, 4>& box, const SliceLayout& layout,
             std::vector<std::uint8_t>& marks) {
  const auto& [is, js, us, vs] = box;
  for (int j = js.first; j <= js.last; ++j)
    for (int v = vs.first; v <= vs.last; ++v) {
      const std::uint32_t row = layout.rowStart[std::size_t(j)] + std::uint32_t(v) * layout.width;
      for (int i = is.first; i <= is.last; ++i)
        for (int u = us.first; u <= us.last; ++u)
          std::atomic_ref(marks[row + layout.columnStart[std::size_t(i)] + std::uint32_t(u)])
              .store(1, std::memory_order_relaxed);
    }
}

}  // namespace

ViewRays::ViewRays(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                   const Progress& progress)
    : m_job(job), m_progress(forThreads(progress)), m_display(job.display, job.twin) {
  const Camera camera(job.state.camera, job.state.intrinsics);
  checkContent(job);
  m_plan = hogelscope::plan(job, m_display);
  m_lensKey = lensKeyOf(camera, job.state, job.sampling, job.method);
  m_samples = samplesOf(job.sampling.samplesPerPixel, m_plan.aperture.points.size());
  for (const AperturePoint& point : m_plan.aperture.points) {
    const RigidTransform displayFromPoint =
        m_display.displayFromWorld() * fromPoint(camera.worldFromCamera(), point);
    m_eyes.push_back(displayFromPoint.origin);
    m_maps.push_back(hitMapOf(displayFromPoint, m_display));
    m_maps.back().isSingle = job.method.isSingle;
  }
  if (!m_plan.aperture.isPinhole)
    m_middle = middleOf(m_display.displayFromWorld() * camera.worldFromCamera(), m_display);
  for (int x = 0; x < job.state.camera.res[0]; ++x)
    m_x.push_back((x - m_lensKey.centre.x) / m_lensKey.focalLength.x);
  if (m_plan.isTableKept && !seesNothing()) {
    LensKey key = m_lensKey;
    key.hasStrips = m_plan.usesStrips;
    m_lens = tables.get(key, parallelRows, m_progress);
  }
  if (!m_lens) m_rays.emplace(m_lensKey, m_progress);
  if (m_plan.hasLens || seesNothing() || m_samples.size() > 1) return;
  if (Outline outline(m_maps.front()); outline.isKnown()) m_outline = std::move(outline);
}

std::array<int, 4> ViewRays::seenParts(int y, int x0, int x1) const {
  if (!m_outline) return {x0, x1, x1, x1};
  const double py = plainY(y);
  const RowPart row{*plainX(x0), *plainX(x1 - 1)};
  const auto column = [&](double x) { return x * m_lensKey.focalLength.x + m_lensKey.centre.x; };
  const auto within = [&](double at) { return int(std::clamp(at, double(x0), double(x1))); };
  const RowPart some = m_outline->mayHit(py, row);
  if (!(some[0] <= some[1])) return {x0, x0, x0, x0};
  int first = within(std::ceil(column(some[0])) - 1);
  int last = within(std::floor(column(some[1])) + 2);
  if (m_plan.knowsOutline) {
    // The ends are decided by the rays themselves, not by the rounding of the outline.
    const auto isUnseen = [&](int x) {
      CellBatch batch;
      findCells(m_maps.front(), plainX(x), &py, 1, batch);
      return batch.seen[0] == 0;
    };
    while (first < last && isUnseen(first)) ++first;
    while (first < last && isUnseen(last - 1)) --last;
    return {first, first, last, last};
  }
  const RowPart all = m_outline->hits(py, row);
  const int from = all[0] <= all[1] ? within(std::ceil(column(all[0])) + 1) : last;
  const int to = within(std::floor(column(all[1])));
  if (first <= from && from < to && to <= last) return {first, from, to, last};
  return {first, last, last, last};
}

std::int64_t ViewRays::count() const {
  const auto [width, height] = m_job.state.camera.res;
  if (seesNothing()) return 0;
  if (!m_plan.knowsOutline) return std::int64_t(m_samples.size()) * width * height;
  std::int64_t seen = 0;
  for (int y = 0; y < height; ++y) {
    const std::array<int, 4> parts = seenParts(y, 0, width);
    seen += parts[3] - parts[0];
  }
  return seen;
}

void ViewRays::ideals(int y, int x0, int count, const RaySample& sample, IdealBatch& points) const {
  throwIfCancelled(m_progress);
  points.x = points.madeX.data();
  points.y = points.madeY.data();
  if (m_lens) {
    points.x = m_lens->x(y, sample) + x0;
    points.y = m_lens->y(y, sample) + x0;
  } else if (!m_plan.hasLens && m_lensKey.samplesPerPixel == 1) {
    points.x = plainX(x0);
    points.madeY.fill(plainY(y));
  } else {
    m_rays->row(y, sample, x0, count, points.madeX.data(), points.madeY.data());
  }
}

void ViewRays::cellsOf(const IdealBatch& ideals, int count, std::size_t point, CellBatch& batch,
                       std::size_t channel) const {
  if (isInFront(point))
    findCells(m_maps[point], ideals.x, ideals.y, count, batch, channel);
  else
    std::fill_n(batch.seen.begin(), count, std::uint8_t{0});
}

void ViewRays::cells(int y, int x0, int count, const RaySample& sample, CellBatch& batch) const {
  IdealBatch made;
  if (!seesNothing()) ideals(y, x0, count, sample, made);
  cellsOf(made, count, sample.point, batch);
}

void ViewRays::lines(int y, int x0, int count, const RaySample& sample, LineBatch& batch) const {
  IdealBatch made;
  CellBatch found;
  if (!seesNothing()) ideals(y, x0, count, sample, made);
  cellsOf(made, count, sample.point, found);
  const HitMap& map = m_maps[sample.point];
  batch.seen = found.seen;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    if (batch.seen[k] == 0) continue;
    const auto along = [&](std::size_t c) {
      return made.x[k] * map.right[c] + made.y[k] * map.down[c] + map.forward[c];
    };
    batch.slopes[k] = {along(0) / along(2), along(1) / along(2)};
  }
}

Footprint ViewRays::footprint(int y, int x0, int x1) const {
  Footprint result(m_display.size().nx, m_display.size().ny);
  addFootprint(y, x0, x1, result);
  return result;
}

/// Calls `use` with the cells of all rays of pixels [x0, x1), batch after batch.
template <class Use>
void ViewRays::eachBatch(int y, int x0, int x1, const Use& use) const {
  if (seesNothing()) return;
  IdealBatch made;
  CellBatch batch;
  for (int x = x0; x < x1; x += batchSize) {
    const int count = std::min(batchSize, x1 - x);
    for (const RaySample& sample : samplesFrom(0)) {
      ideals(y, x, count, sample, made);
      for (std::size_t point = 0; point < points(); ++point)
        for (std::size_t channel = 0; channel < (m_plan.splitsColours ? 3 : 1); ++channel) {
          cellsOf(made, count, point, batch, channel);
          use(static_cast<std::size_t>(count), batch);
        }
    }
  }
}

void ViewRays::addFootprint(int y, int x0, int x1, Footprint& result) const {
  const LightFieldSize& size = m_display.size();
  const Reconstruction reconstruction = m_job.sampling.reconstruction;
  const Reach reach{reconstruction == Reconstruction::quadrilinear ? 1 : m_plan.spotReach,
                    m_plan.psfReach + (reconstruction == Reconstruction::nearest ? 0 : 1)};
  const float near = border();
  eachBatch(y, x0, x1, [&](std::size_t count, const CellBatch& batch) {
    const auto add = [&](std::vector<CellRange>& ranges, std::size_t axis, std::size_t k,
                         int directions) {
      const auto hogel = static_cast<int>(batch.cell[axis][k]);
      const auto direction = static_cast<int>(batch.cell[axis + 2][k]);
      widen(ranges, hogel, direction, reach, directions);
      if (near == 0) return;
      // One more cell on the side that the ray is close to.
      const auto aside = [&](std::size_t of) {
        const float place = batch.place[of][k];
        return place < near ? -1 : place > 1 - near ? 1 : 0;
      };
      const auto [away, turned] = std::pair(aside(axis), aside(axis + 2));
      if (away == 0 && turned == 0) return;
      const int other = std::clamp(direction + turned, 0, directions - 1);
      const int beside = std::clamp(hogel + away, 0, int(ranges.size()) - 1);
      for (const int cell : {hogel, beside})
        for (const int each : {direction, other}) widen(ranges, cell, each, reach, directions);
    };
    for (std::size_t k = 0; k < count; ++k) {
      if (batch.seen[k] == 0) continue;
      add(result.u, 0, k, size.du);
      add(result.v, 1, k, size.dv);
    }
  });
}

void ViewRays::mark(int y, const SliceLayout& layout, std::vector<std::uint8_t>& marks) const {
  const int width = m_job.state.camera.res[0];
  const bool areDirections = m_job.sampling.reconstruction != Reconstruction::nearest;
  const bool areHogels = m_job.sampling.reconstruction == Reconstruction::quadrilinear;
  const auto [nx, ny, du, dv] = m_display.size();
  const std::array counts{nx, ny, du, dv};
  const std::array reaches{m_plan.spotReach, 0, m_plan.psfReach, m_plan.psfReach};
  eachBatch(y, 0, width, [&](std::size_t count, const CellBatch& batch) {
    for (std::size_t k = 0; k < count; ++k) {
      if (batch.seen[k] == 0) continue;
      std::array<CellRange, 4> box;
      for (std::size_t axis = 0; axis < 4; ++axis)
        box[axis] =
            cellsRead(batch.cell[axis][k], batch.place[axis][k],
                      axis < 2 ? areHogels : areDirections, border(), reaches[axis], counts[axis]);
      markBox(box, layout, marks);
    }
  });
}

/// Whether hogel columns and u depend on the pixel's column alone, hogel rows and v on its row: the
/// view then reads its whole footprint.
bool ViewRays::isSeparable() const {
  const HitMap& map = m_maps.front();
  return !m_plan.hasLens && !m_plan.movesRays && points() == 1 && map.right[1] == 0 &&
         map.right[2] == 0 && map.down[0] == 0 && map.down[2] == 0;
}

ViewReads ViewRays::reads(const ParallelRows& parallelRows) const {
  ViewReads reads;
  reads.footprint = [this, parallelRows] { return footprint(parallelRows); };
  if (isSeparable()) return reads;
  reads.mark = [this, parallelRows](const SliceLayout& layout, std::vector<std::uint8_t>& marks) {
    parallelRows(m_job.state.camera.res[1], [&](int begin, int end) {
      for (int y = begin; y < end; ++y) mark(y, layout, marks);
    });
  };
  return reads;
}

/// Returns the footprint of a separable view: the union of what one row and one column read.
Footprint ViewRays::separableFootprint() const {
  const auto [width, height] = m_job.state.camera.res;
  Footprint all(m_display.size().nx, m_display.size().ny);
  int y = 0;
  while (y < height && all.texels() == 0) addFootprint(y++, 0, width, all);
  if (all.texels() == 0) return all;
  int x = 0;
  while (footprint(y - 1, x, x + 1).texels() == 0) ++x;
  for (; y < height; ++y) addFootprint(y, x, x + 1, all);
  return all;
}

Footprint ViewRays::footprint(const ParallelRows& parallelRows) const {
  if (isSeparable()) return separableFootprint();
  const auto [width, height] = m_job.state.camera.res;
  Footprint all(m_display.size().nx, m_display.size().ny);
  std::mutex mutex;
  parallelRows(height, [&, width = width](int begin, int end) {
    Footprint ofRows(m_display.size().nx, m_display.size().ny);
    for (int y = begin; y < end; ++y) addFootprint(y, 0, width, ofRows);
    const std::lock_guard lock(mutex);
    all.include(ofRows);
  });
  return all;
}

}  // namespace hogelscope
