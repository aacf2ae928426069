// SPDX-License-Identifier: BSD-3-Clause
#include "core/lens/lens_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hogelscope {

namespace {

Vec2 times(double s, const Vec2& p) {
  return {s * p.x, s * p.y};
}

/// Maps between a point of the world, on the plane z = 1, and its point of the image.
class Mapping {
 public:
  Mapping(const LensKey& lens, const Progress& progress)
      : m_lens(lens),
        m_distortion(lens.distortion),
        m_inverse(Distortion(lens.distortion), progress) {}

  [[nodiscard]] Vec2 pixel(const Vec2& onSensor) const {
    return {m_lens.focalLength.x * onSensor.x + m_lens.centre.x,
            m_lens.focalLength.y * onSensor.y + m_lens.centre.y};
  }
  /// Returns NaN where the lens folds before the point.
  [[nodiscard]] Vec2 undistort(Vec2 p) const {
    m_inverse.undistort(&p.x, &p.y, 1);
    return p;
  }
  /// Returns the point of the image that shows a point of the world; NaN if none does.
  [[nodiscard]] Vec2 shown(const Vec2& world) const {
    if (m_lens.mapping == LensMapping::direct) return undistort(world);
    const Vec2 place = m_distortion.distort(world);
    const Vec2 back = undistort(place);
    const double miss = std::hypot(back.x - world.x, back.y - world.y);
    if (miss <= 1e-6 * (1 + std::hypot(world.x, world.y))) return place;
    return {std::nan(""), std::nan("")};
  }
  /// Returns the point of the world under a point of the image.
  [[nodiscard]] Vec2 seen(const Vec2& onSensor) const {
    return m_lens.mapping == LensMapping::direct ? m_distortion.distort(onSensor)
                                                 : undistort(onSensor);
  }

 private:
  const LensKey& m_lens;
  Distortion m_distortion;
  BatchUndistort m_inverse;
};

struct Border {
  Vec2 first;
  Vec2 last;
};

/// Returns the image's corners on the plane z = 1.
Border borderOf(const LensKey& lens) {
  return {lens.onSensor(-0.5, -0.5), lens.onSensor(lens.res[0] - 0.5, lens.res[1] - 0.5)};
}

/// Returns how far from the axis the world is seen, across or down, whichever is more.
double reachOf(const Border& border, const Mapping& mapping) {
  constexpr int steps = 32;
  double reach = 0;
  for (int row = 0; row <= steps; ++row)
    for (int column = 0; column <= steps; ++column) {
      const Vec2 at{std::lerp(border.first.x, border.last.x, double(column) / steps),
                    std::lerp(border.first.y, border.last.y, double(row) / steps)};
      const Vec2 world = mapping.seen(at);
      if (!std::isnan(world.x)) reach = std::max({reach, std::abs(world.x), std::abs(world.y)});
    }
  return reach;
}

/// Adds a line, which is cut where a point is not shown.
void addLine(const Vec2& from, const Vec2& to, const Mapping& mapping, LensGrid& grid) {
  constexpr int steps = 96;
  grid.lines.emplace_back();
  for (int k = 0; k <= steps; ++k) {
    const double share = double(k) / steps;
    const Vec2 place =
        mapping.shown({std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share)});
    if (!std::isnan(place.x))
      grid.lines.back().push_back(mapping.pixel(place));
    else if (!grid.lines.back().empty())
      grid.lines.emplace_back();
  }
  if (grid.lines.back().size() < 2) grid.lines.pop_back();
}

/// Adds the fold. By definition a point has a ray only if all points between the centre and it have
/// one, so each direction has one end.
void addFold(const Border& border, const Mapping& mapping, LensGrid& grid) {
  constexpr int directions = 128;
  constexpr int halvings = 18;  // a hundredth of a pixel
  const double farthest = std::hypot(std::max(std::abs(border.first.x), std::abs(border.last.x)),
                                     std::max(std::abs(border.first.y), std::abs(border.last.y)));
  bool folds = false;
  for (int k = 0; k < directions; ++k) {
    const double angle = 2 * std::numbers::pi * k / directions;
    const Vec2 unit{std::cos(angle), std::sin(angle)};
    double good = farthest;
    if (std::isnan(mapping.undistort(times(farthest, unit)).x)) {
      folds = true;
      good = 0;
      for (int halving = 1; halving <= halvings; ++halving) {
        const double step = std::ldexp(farthest, -halving);
        if (!std::isnan(mapping.undistort(times(good + step, unit)).x)) good += step;
      }
    }
    grid.fold.push_back(mapping.pixel(times(good, unit)));
  }
  if (!folds) grid.fold.clear();
}

}  // namespace

LensGrid lensGrid(const LensKey& lens, const Progress& progress) {
  constexpr int mostLines = 40;  // on each side of the axis
  const Mapping mapping(lens, progress);
  const Border border = borderOf(lens);
  const double square = (border.last.y - border.first.y) / 10;
  const double reach = reachOf(border, mapping);
  const int lines = std::min(int(std::min(std::ceil(reach / square), 1e6)), mostLines);
  LensGrid grid{lens.res, {}, {}};
  for (int k = -lines; k <= lines; ++k) {
    const double at = k * square;
    const double end = lines * square;
    addLine({at, -end}, {at, end}, mapping, grid);
    addLine({-end, at}, {end, at}, mapping, grid);
  }
  if (lens.mapping == LensMapping::exact) addFold(border, mapping, grid);
  return grid;
}

}  // namespace hogelscope
