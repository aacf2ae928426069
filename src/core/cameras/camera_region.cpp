// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/camera_region.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace hogelscope {

namespace {

constexpr std::array<std::string_view, 3> spreadNames{"uniform", "random", "normal"};
constexpr std::array<std::string_view, 3> regionNames{"box", "plane", "arc"};
constexpr std::array<std::string_view, 3> lookatNames{"fixed", "nearest", "jittered"};

/// Returns the region's three coordinates: x, y, z, or angle, elevation, distance.
struct Sides {
  Vec3 low;
  Vec3 high;
};

Sides sidesOf(const CameraRegionParams& p) {
  if (p.region == RegionShape::arc)
    return {{p.angle[0], p.elevation[0], p.distance[0]},
            {p.angle[1], p.elevation[1], p.distance[1]}};
  Vec3 half = 0.5 * p.extent;
  if (p.region == RegionShape::plane) half.z = 0;
  return {p.centre - half, p.centre + half};
}

/// Returns the lengths of the sides in metres, of an arc at its middle distance.
std::array<double, 3> lengthsOf(const CameraRegionParams& p) {
  const Sides sides = sidesOf(p);
  const Vec3 length = sides.high - sides.low;
  if (p.region != RegionShape::arc) return {length.x, length.y, length.z};
  const double middle = (sides.low.z + sides.high.z) / 2;
  return {middle * radians(length.x), middle * radians(length.y), length.z};
}

/// Returns the point at fractions 0 … 1 of the sides.
Vec3 pointAt(const CameraRegionParams& p, const Vec3& fraction) {
  const Sides sides = sidesOf(p);
  const Vec3 at{sides.low.x + fraction.x * (sides.high.x - sides.low.x),
                sides.low.y + fraction.y * (sides.high.y - sides.low.y),
                sides.low.z + fraction.z * (sides.high.z - sides.low.z)};
  if (p.region != RegionShape::arc) return at;
  const double angle = radians(at.x);
  const double elevation = radians(at.y);
  const double across = at.z * std::cos(elevation);
  return {across * std::sin(angle), at.z * std::sin(elevation), across * std::cos(angle)};
}

double drawn(const CameraRegionParams& p, RandomNumbers& random) {
  if (p.distribution == CameraSpread::random) return random.unit();
  double fraction = 0;
  do {
    fraction = 0.5 + p.deviation * random.normal();
  } while (fraction < 0 || fraction > 1);
  return fraction;
}

/// Returns the fractions of the sides at a point of a grid.
Vec3 gridFraction(const GridSize& grid, long long index) {
  const auto along = [](long long k, int count) {
    return count == 1 ? 0.5 : double(k) / (count - 1);
  };
  const long long perLayer = static_cast<long long>(grid.columns) * grid.rows;
  return {along(index % grid.columns, grid.columns),
          1 - along(index % perLayer / grid.columns, grid.rows),
          along(index / perLayer, grid.layers)};
}

void checkOrder(const std::array<double, 2>& ends, const std::string& path) {
  if (ends[1] < ends[0]) throw InputError(path, "ends before it begins: give [least, most]");
}

}  // namespace

void describe(ParameterVisitor& v, CameraRegionParams& p) {
  auto& [distribution, region, centre, extent, distance, angle, elevation, deviation, lookat,
         target, jitter] = p;
  v.group("cameraRegion",
          "Where the cameras of a set stand and look; all in the display frame: origin at the "
          "panel's centre, +x right, +y up, +z to the viewer.");
  v.field("distribution", distribution, spreadNames,
          "A regular grid, uniform random, or Gaussian about the region's middle.");
  v.field("region", region, regionNames,
          "A box, a plane parallel to the panel, or an arc about the panel's centre.");
  const bool isArc = region == RegionShape::arc;
  v.count(!isArc);
  v.field("centre", centre, {-1e4, 1e4, 0.01}, "m", "Box, plane: the middle.");
  v.field("extent", extent, {0, 1e4, 0.01}, "m",
          "Box, plane: full width, height and depth; a plane has no depth.");
  v.count(isArc);
  v.field("distance", distance, {1e-6, 1e4, 0.01}, "m", "Arc: least and most, from the centre.");
  v.field("angle", angle, {-89, 89, 1}, "°", "Arc: from and to, below 0 is left of the normal.");
  v.field("elevation", elevation, {-89, 89, 1}, "°", "Arc: from and to, above 0 is upwards.");
  v.count(distribution == CameraSpread::normal);
  v.field("deviation", deviation, {0.01, 10, 0.01}, "",
          "Normal: standard deviation as a share of the region's full width along each side.");
  v.count(true);
  v.field({"lookat", "Look at"}, lookat, lookatNames,
          "At the target, at the panel's point nearest to the eye, or near the target.");
  v.count(lookat != LookAt::nearest);
  v.field("target", target, {-1e4, 1e4, 0.01}, "m", "Fixed, jittered: where the cameras look.");
  v.count(lookat == LookAt::jittered);
  v.field("jitter", jitter, {0, 1e4, 0.01}, "m",
          "Jittered: farthest shift of the target along x and along y, uniform random.");
  v.count(true);
}

void check(const CameraRegionParams& region, const std::string& path) {
  checkOrder(region.distance, path + ".distance");
  checkOrder(region.angle, path + ".angle");
  checkOrder(region.elevation, path + ".elevation");
  if (region.region != RegionShape::arc && !(sidesOf(region).low.z > 0))
    throw InputError(path + ".centre",
                     "brings the region to the panel or behind it: its z must be above 0, and "
                     "above half the depth of a box");
}

GridSize gridFor(const CameraRegionParams& region, int count) {
  const std::array<double, 3> lengths = lengthsOf(region);
  int sides = 0;
  double volume = 1;
  std::size_t last = 0;  // its count follows from the other two
  for (std::size_t side = 0; side < 3; ++side) {
    if (!(lengths[side] > 0)) continue;
    last = side;
    volume *= lengths[side];
    ++sides;
  }
  if (sides == 0) return {count, 1, 1};
  const double step = std::pow(volume / count, 1.0 / sides);
  const auto most = [&](std::size_t side) { return lengths[side] > 0 && side != last ? count : 1; };
  const auto costOf = [&](const std::array<int, 3>& n) {
    double cost = std::log(double(n[0]) * n[1] * n[2] / count);
    for (std::size_t side = 0; side < 3; ++side)
      if (lengths[side] > 0) cost += std::pow(std::log(n[side] * step / lengths[side]), 2);
    return cost;
  };
  std::array<int, 3> best{};
  double least = HUGE_VAL;
  for (int columns = most(0); columns >= 1; --columns) {
    for (int rows = std::min(most(1), count / columns); rows >= 1; --rows) {
      std::array<int, 3> grid{columns, rows, 1};
      grid[last] = (count + columns * rows - 1) / (columns * rows);
      const double cost = costOf(grid);
      if (!(cost < least - 1e-9)) continue;  // ties are decided by order, not by rounding
      least = cost;
      best = grid;
    }
  }
  return {best[0], best[1], best[2]};
}

Vec3 lookatFrom(const CameraRegionParams& region, const Vec3& eye,
                const std::array<double, 2>& panel, RandomNumbers& random) {
  if (region.lookat == LookAt::nearest)
    return {std::clamp(eye.x, -panel[0] / 2, panel[0] / 2),
            std::clamp(eye.y, -panel[1] / 2, panel[1] / 2), 0};
  if (region.lookat == LookAt::fixed) return region.target;
  const double x = region.jitter * (2 * random.unit() - 1);
  const double y = region.jitter * (2 * random.unit() - 1);
  return region.target + Vec3{x, y, 0};
}

std::vector<CameraPose> posesIn(const CameraRegionParams& region, int count,
                                const std::array<double, 2>& panel, RandomNumbers& random) {
  const bool isGrid = region.distribution == CameraSpread::uniform;
  const GridSize grid = isGrid ? gridFor(region, count) : GridSize{};
  const long long points = static_cast<long long>(grid.columns) * grid.rows * grid.layers;
  std::vector<CameraPose> poses;
  for (int k = 0; k < count; ++k) {
    Vec3 fraction;
    if (isGrid) {
      fraction = gridFraction(grid, (2LL * k + 1) * points / (2LL * count));
    } else {
      fraction.x = drawn(region, random);
      fraction.y = drawn(region, random);
      fraction.z = drawn(region, random);
    }
    const Vec3 eye = pointAt(region, fraction);
    poses.push_back({eye, lookatFrom(region, eye, panel, random)});
  }
  return poses;
}

}  // namespace hogelscope
