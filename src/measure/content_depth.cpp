// SPDX-License-Identifier: BSD-3-Clause
#include "measure/content_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/engine/view_rays.h"
#include "core/panel/design_numbers.h"

namespace hogelscope {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Returns the direction that an eye sees at the panel's centre, or the nearest one that there is.
std::array<int, 2> directionAtCentre(const PanelParams& params, const Vec3& eye) {
  const Display display(params);
  const auto hit = display.intersectPlane(eye, {-eye.x, -eye.y, -eye.z});
  const LightFieldSize& size = display.size();
  const auto nearest = [](double place, int count) {
    return int(std::floor(std::clamp(place, 0.0, count - 0.5)));
  };
  if (!hit) return {size.du / 2, size.dv / 2};
  return {nearest(hit->u, size.du), nearest(hit->v, size.dv)};
}

/// The rays of a row's pixels that see the display.
struct RowRays {
  std::vector<std::size_t> columns;
  std::vector<Vec2> slopes;
};

RowRays raysOfRow(const ViewRays& rays, int y, int width) {
  RowRays row;
  for (int x0 = 0; x0 < width; x0 += batchSize) {
    const int count = std::min(batchSize, width - x0);
    LineBatch batch;
    rays.lines(y, x0, count, rays.samplesFrom(0).front(), batch);
    for (int k = 0; k < count; ++k) {
      if (batch.seen[std::size_t(k)] == 0) continue;
      row.columns.push_back(std::size_t(x0 + k));
      row.slopes.push_back(batch.slopes[std::size_t(k)]);
    }
  }
  return row;
}

/// Returns the depths at the hogels that the rays meet.
std::vector<double> atHogels(const HogelDepths& depths, const Display& display, const Vec3& eye,
                             const std::vector<Vec2>& slopes) {
  std::vector<double> z;
  z.reserve(slopes.size());
  const LightFieldSize& size = display.size();
  for (const auto& [a, b] : slopes) {
    const auto hit = display.intersectPlane(eye, {-a, -b, -1});
    z.push_back(hit ? depths.at(std::clamp(int(hit->i), 0, size.nx - 1),
                                std::clamp(int(hit->j), 0, size.ny - 1))
                    : unknown);
  }
  return z;
}

}  // namespace

PixelDepths depthsOf(const RenderJob& job, LensTables& tables, const Progress& progress) {
  RenderJob pinhole = job;  // the middle of the pupil and of each pixel
  pinhole.state.pupil = {};
  pinhole.sampling.samplesPerPixel = 1;
  const ViewRays rays(pinhole, tables, parallelRows, progress);
  const auto [width, height] = job.state.camera.res;
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  PixelDepths result{std::vector<double>(pixels, unknown), std::vector<std::uint8_t>(pixels)};
  if (rays.seesNothing()) return result;
  const Vec3 eye = rays.eye(0);
  const Display display(job.display);
  const LiveScene* const scene = job.lightField->scene();
  HogelDepths known;
  if (scene == nullptr)
    known = depthsByDisparity(*job.lightField, job.display, directionAtCentre(job.display, eye),
                              part(progress, 0, 0.8));
  const Progress traced = forThreads(part(progress, scene != nullptr ? 0 : 0.8, 1));
  std::atomic<int> done = 0;
  parallelRows(height, [&, width = width, height = height](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const RowRays row = raysOfRow(rays, y, width);
      std::vector<double> z(row.slopes.size());
      if (scene != nullptr)
        scene->traceDepths(eye, row.slopes, z);
      else
        z = atHogels(known, display, eye, row.slopes);
      const std::size_t first = std::size_t(y) * std::size_t(width);
      for (std::size_t k = 0; k < z.size(); ++k) {
        result.z[first + row.columns[k]] = z[k];
        result.seen[first + row.columns[k]] = 1;
      }
      reportProgress(traced, double(++done) / height);
    }
  });
  return result;
}

DepthFigures depthFigures(const std::string& state, const PixelDepths& depths,
                          const DepthLimits& limits, double share) {
  DepthFigures figures{state, limits, {}, {}};
  for (const double z : depths.z)
    if (z < limits.distance) figures.dioptres.push_back(dioptresAt(z, limits.distance));
  std::ranges::sort(figures.dioptres);
  const std::vector<double>& all = figures.dioptres;
  if (all.empty()) return figures;
  const auto within = [&all](double limit) {
    const auto isInside = [limit](double dioptres) {
      return DepthLimits::isWithin(dioptres, limit);
    };
    return double(std::ranges::count_if(all, isInside)) / double(all.size());
  };
  figures.known = double(all.size()) / double(std::ranges::count(depths.seen, 1));
  figures.insideDisplay = within(limits.display);
  figures.inside = within(limits.both());
  figures.ghosts = 1 - within(2 * limits.display);
  figures.interval = shortestInterval(all, share);
  return figures;
}

double farthestOf(const DepthFigures& figures) {
  const std::vector<double>& all = figures.dioptres;
  return all.empty() ? 0 : std::max(std::abs(all.front()), std::abs(all.back()));
}

double barsEnd(const DepthFigures& now, const DepthFigures* proposed) {
  double end = std::min(now.limits.display, 1 / now.limits.distance);
  end = std::max(end, farthestOf(now));
  if (proposed != nullptr) end = std::max(end, farthestOf(*proposed));
  return 1.18 * end;
}

DepthBars depthBars(const DepthFigures& figures, double end) {
  constexpr std::size_t count = 160;
  DepthBars bars{-end, 2 * end / double(count), std::vector<double>(count)};
  for (const double dioptres : figures.dioptres) {
    const double place = (dioptres + end) / bars.width;
    bars.shares[std::size_t(std::clamp(place, 0.0, double(count - 1)))] +=
        1 / double(figures.dioptres.size());
  }
  return bars;
}

}  // namespace hogelscope
