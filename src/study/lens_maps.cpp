// SPDX-License-Identifier: BSD-3-Clause
// Maps of lenses, and the line beyond which a lens folds within the image.
#include "study/lens_maps.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "core/engine/plan.h"

namespace hogelscope {

namespace {

constexpr int pointsPerSide = 9;

/// Consecutive points; none where the lenses of the map do not fold.
using FoldEnds = std::vector<std::optional<Vec2>>;

/// Returns the border of the image, corners first, because they are the farthest out. A pixel
/// inside has a ray if the border pixel of the same direction has one.
std::vector<Vec2> borderOf(const LensKey& camera) {
  constexpr int steps = 16;
  std::vector<Vec2> border;
  const double x = camera.centre.x / camera.focalLength.x;
  const double y = camera.centre.y / camera.focalLength.y;
  for (int k = 0; k < steps; ++k) {
    const double t = 1 - 2.0 * k / steps;
    border.insert(border.end(), {{t * x, y}, {x, -t * y}, {-t * x, -y}, {-x, t * y}});
  }
  return border;
}

/// Finds points of a plane's fold line.
class FoldFinder {
 public:
  FoldFinder(const LensPlane& plane, const Progress& progress)
      : m_plane(plane), m_border(borderOf(paperCamera({}))), m_progress(progress) {}

  /// Returns the fold line between two angles, the latter excluded.
  [[nodiscard]] FoldEnds between(double from, double to) const {
    FoldEnds ends;
    refine(from, along(from), to, along(to), 0, ends);
    return ends;
  }

 private:
  /// Returns the line's point in a direction of the plane; none within the map. The fold moves
  /// inwards monotonically along a direction.
  [[nodiscard]] std::optional<Vec2> along(double angle) const {
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    double folds = m_plane.reach() / std::max(std::abs(x), std::abs(y));  // the map's border
    double holds = 0;
    if (holdsAt(folds * x, folds * y)) return std::nullopt;
    constexpr int halvings = 12;  // far below a pixel of the map
    for (int k = 0; k < halvings; ++k) {
      const double middle = (holds + folds) / 2;
      (holdsAt(middle * x, middle * y) ? holds : folds) = middle;
    }
    return Vec2{holds * x, holds * y};
  }

  [[nodiscard]] bool holdsAt(double x, double y) const {
    const Distortion distortion(m_plane.lens(x, y));
    return std::ranges::all_of(m_border, [&](const Vec2& p) {
      throwIfCancelled(m_progress);
      return distortion.undistort(p).has_value();
    });
  }

  /// Adds the points before `to`, close enough for a smooth line and up to the map's border.
  void refine(double from, const std::optional<Vec2>& first, double to,
              const std::optional<Vec2>& last, int depth, FoldEnds& ends) const {
    constexpr int deepest = 7;
    const double near = 0.04 * m_plane.reach();
    const bool isSmooth =
        first && last ? std::hypot(last->x - first->x, last->y - first->y) < near : !first && !last;
    if (isSmooth || depth == deepest) {
      ends.push_back(first);
      return;
    }
    const double middle = (from + to) / 2;
    const std::optional<Vec2> between = along(middle);
    refine(from, first, middle, between, depth + 1, ends);
    refine(middle, between, to, last, depth + 1, ends);
  }

  LensPlane m_plane;
  std::vector<Vec2> m_border;
  Progress m_progress;
};

std::vector<std::vector<Vec2>> foldLineOf(const LensPlane& plane, const ParallelRows& parallelRows,
                                          const Progress& progress) {
  constexpr int directions = 96;
  const auto angle = [](int k) { return 2 * std::numbers::pi * k / directions; };
  const FoldFinder finder(plane, progress);
  std::vector<FoldEnds> parts(directions);
  std::atomic<int> done = 0;
  parallelRows(directions, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      parts[std::size_t(k)] = finder.between(angle(k), angle(k + 1));
      reportProgress(progress, double(++done) / directions);
    }
  });
  parts.push_back({parts[0][0]});  // closes the line
  std::vector<std::vector<Vec2>> pieces;
  bool continues = false;
  for (const FoldEnds& part : parts) {
    for (const std::optional<Vec2>& end : part) {
      if (end && !continues) pieces.emplace_back();
      if (end) pieces.back().push_back(*end);
      continues = end.has_value();
    }
  }
  return pieces;
}

}  // namespace

DistortionParams LensPlane::lens(double x, double y) const {
  DistortionParams params;
  params.*across = x;
  params.*upwards = y;
  return params;
}

const std::vector<LensPlane>& lensPlanes() {
  static const std::vector<LensPlane> planes{
      {"k1_k2", {"k1", "k2"}, &DistortionParams::k1, &DistortionParams::k2, 32, 32},
      {"p1_p2", {"p1", "p2"}, &DistortionParams::p1, &DistortionParams::p2, 32, 160}};
  return planes;
}

LensKey paperCamera(const DistortionParams& distortion) {
  CameraState state;
  state.camera.fov = 60;
  state.camera.res = {600, 600};
  state.distortion = distortion;
  return lensKeyOf(state, {});
}

LensMap measureMap(const LensPlane& plane, const ParallelRows& parallelRows,
                   const Progress& progress) {
  const int side = plane.side();
  const auto& methods = inverseMethods();
  constexpr double foldShare = 0.3;  // approximate share of the time
  const Progress heard = forThreads(progress);
  LensMap map{plane, {}, foldLineOf(plane, parallelRows, part(heard, 0, foldShare))};
  map.outcomes.assign(methods.size(),
                      std::vector<LensOutcomes>(std::size_t(side) * std::size_t(side)));
  for (int row = 0; row < side; ++row) {
    const double done = foldShare + (1 - foldShare) * row / side;
    const Progress ofRow = part(heard, done, done);
    parallelRows(side, [&](int begin, int end) {
      for (int column = begin; column < end; ++column) {
        const LensTrial trial(paperCamera(plane.lens(plane.at(column), plane.at(row))),
                              pointsPerSide, pointsPerSide, ofRow);
        const auto at = std::size_t(row) * std::size_t(side) + std::size_t(column);
        for (std::size_t m = 0; m < methods.size(); ++m)
          map.outcomes[m][at] = trial.outcomes(methods[m]);
      }
    });
  }
  return map;
}

}  // namespace hogelscope
