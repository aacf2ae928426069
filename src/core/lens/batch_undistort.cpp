// SPDX-License-Identifier: BSD-3-Clause
// The inverse of a lens for many points: plain Newton where any root is the right one.
#include "core/lens/batch_undistort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/lens/lens_steps.h"
#include "core/optics/lens_branch.h"

namespace hogelscope {

namespace {

/// Points that are iterated together: small enough for the first-level cache.
constexpr int pointsAtOnce = 128;

constexpr int mostSteps = 20;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Newton's error is squared by the next step: after a move this short it is below rounding.
constexpr double shortMoveSquared = 1e-18;

double squaredNorm(const Vec2& a) {
  return a.x * a.x + a.y * a.y;
}

Disc discAround(const double* x, const double* y, int count) {
  const auto [left, right] = std::minmax_element(x, x + count);
  const auto [top, bottom] = std::minmax_element(y, y + count);
  return {{(*left + *right) / 2, (*top + *bottom) / 2},
          count > 1 ? std::hypot(*right - *left, *bottom - *top) / 2 : 0};
}

}  // namespace

/// Marches outwards as long as the least eigenvalue's bound, which changes by at most the second
/// derivative's bound per length, stays positive.
BatchUndistort::BatchUndistort(const Distortion& distortion, Progress progress)
    : m_distortion(distortion), m_progress(std::move(progress)), m_shadow(distortion) {
  constexpr double farthest = 100;  // beyond any image but those of nearly 180°
  double radius = 0;
  while (radius < farthest) {
    hearStop(m_progress);
    const double longest = std::min(0.2 * radius + 0.05, farthest - radius);
    const double step = m_distortion.safeStep(radius, 0.9 * leastEigenvalue(radius), longest);
    if (!(step > 1e-9 * (1 + radius))) break;
    radius += step;
  }
  const auto& [k1, k2, p1, p2, k3] = m_distortion.params();
  const double r2 = radius * radius;
  m_certainRadius = radius;
  // The least radial part of the model at that radius.
  m_certainDistorted = std::max(
      0.0, radius * (1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2) - 3 * r2 * std::hypot(p1, p2));
}

/// Returns a lower bound over the circle: along and across the radius for the radial terms, less
/// 6 |(p1, p2)| r, the most that the tangential ones can subtract.
double BatchUndistort::leastEigenvalue(double radius) const {
  const auto& [k1, k2, p1, p2, k3] = m_distortion.params();
  const double r2 = radius * radius;
  const double across = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double along = 1 + r2 * (3 * k1 + r2 * (5 * k2 + r2 * 7 * k3));
  return std::min(across, along) - 6 * std::hypot(p1, p2) * radius;
}

void BatchUndistort::undistort(double* x, double* y, int count) const {
  if (m_distortion.isIdentity()) return;
  for (int k = 0; k < count; k += pointsAtOnce)
    undistortBatch(x + k, y + k, std::min(pointsAtOnce, count - k));
}

void BatchUndistort::undistortBatch(double* x, double* y, int count) const {
  std::array<double, pointsAtOnce> idealX;
  std::array<double, pointsAtOnce> idealY;
  std::array<double, pointsAtOnce> move;
  std::copy_n(x, count, idealX.data());
  std::copy_n(y, count, idealY.data());
  for (int step = 0; step < mostSteps; ++step)
    if (newtonStep(m_distortion.params(), m_certainDistorted, x, y, count, idealX.data(),
                   idealY.data(), move.data()) == 0)
      break;
  const auto isCertain = [&](int k) {
    const auto at = std::size_t(k);
    return squaredNorm({x[k], y[k]}) < m_certainDistorted * m_certainDistorted &&
           squaredNorm({idealX[at], idealY[at]}) < m_certainRadius * m_certainRadius &&
           move[at] < shortMoveSquared;
  };
  int run = 0;  // points before k that are neither certain nor in the shadow
  for (int k = 0; k <= count; ++k) {
    Vec2 root{none, none};
    const bool isQuick = k < count && isCertain(k);
    if (isQuick) root = {idealX[std::size_t(k)], idealY[std::size_t(k)]};
    const bool isDone =
        k == count || isQuick || m_shadow.holds({x[k], y[k]}) || solveInSector({x[k], y[k]}, root);
    if (!isDone) {
      ++run;
      continue;
    }
    if (run > 0)
      followRun(x + k - run, y + k - run, run,
                certainStart(discAround(x + k - run, y + k - run, run)));
    run = 0;
    if (k == count) break;
    x[k] = root.x;
    y[k] = root.y;
  }
}

/// False if the sector is not certain of the point; then `ideal` is left as it is.
bool BatchUndistort::solveInSector(const Vec2& distorted, Vec2& ideal) const {
  if (!std::isfinite(distorted.x + distorted.y)) return false;
  const LensSector sector = m_shadow.sector(distorted);
  if (!(squaredNorm(distorted) > 0 && std::sqrt(squaredNorm(distorted)) < sector.distorted))
    return false;
  hearStop(m_progress);
  Vec2 root = guessInSector(m_distortion.params(), sector, distorted);
  double move = 0;
  for (int step = 0; step < mostSteps; ++step)
    if (newtonStep(m_distortion.params(), std::numeric_limits<double>::infinity(), &distorted.x,
                   &distorted.y, 1, &root.x, &root.y, &move) == 0)
      break;
  if (!(move < shortMoveSquared && squaredNorm(root) < sector.ideal * sector.ideal)) return false;
  ideal = root;
  return true;
}

/// Goes as far as plain Newton is certain for all of the disc.
BranchStart BatchUndistort::certainStart(const Disc& disc) const {
  const double length = std::hypot(disc.centre.x, disc.centre.y);
  // The line through the disc's centre is cut by the segments to the disc this far from there.
  const double halfWidth = length * disc.radius / (length - disc.radius);
  if (!(length > disc.radius)) return {};
  const double reached = 0.9 * std::min(1.0, m_certainDistorted / (length + halfWidth));
  const double x = reached * disc.centre.x;
  const double y = reached * disc.centre.y;
  Vec2 ideal{x, y};
  double move = 0;
  for (int step = 0; step < mostSteps; ++step)
    if (newtonStep(m_distortion.params(), m_certainDistorted, &x, &y, 1, &ideal.x, &ideal.y,
                   &move) == 0)
      break;
  if (reached > 0 && move < shortMoveSquared &&
      squaredNorm(ideal) < m_certainRadius * m_certainRadius)
    return {{disc.centre.x / length, disc.centre.y / length}, reached * length, ideal};
  return {};
}

/// Follows the branch for all points of the run at once, divides it where that says nothing.
void BatchUndistort::followRun(double* x, double* y, int count, const BranchStart& start) const {
  constexpr int parts = 4;
  bool isDark = true;
  for (int k = 0; k < count && isDark; ++k) isDark = m_shadow.holds({x[k], y[k]});
  Branch branch{Branch::Kind::none, {}, {}, 0};
  if (!isDark) branch = followBranch(m_distortion, discAround(x, y, count), m_progress, start);
  const bool isRay = branch.kind == Branch::Kind::ray;
  if (isRay && count == 1) {
    *x = branch.ideal.x;
    *y = branch.ideal.y;
  } else if (isRay && solveFrom(branch.ideal, x, y, count)) {
    return;
  } else if (branch.kind != Branch::Kind::none && count > 1) {
    const int length = (count + parts - 1) / parts;
    for (int k = 0; k < count; k += length)
      followRun(x + k, y + k, std::min(length, count - k), branch.known);
  } else {
    for (int k = 0; k < count; ++k) {
      if (!m_shadow.holds({x[k], y[k]})) m_shadow.learn({x[k], y[k]}, m_progress);
      x[k] = y[k] = none;
    }
  }
}

/// Replaces the points by the roots that Newton finds from `start`. False if it did not find all;
/// then they are left as they are.
bool BatchUndistort::solveFrom(const Vec2& start, double* x, double* y, int count) const {
  std::array<double, pointsAtOnce> idealX;
  std::array<double, pointsAtOnce> idealY;
  std::array<double, pointsAtOnce> move;
  std::fill_n(idealX.data(), count, start.x);
  std::fill_n(idealY.data(), count, start.y);
  for (int step = 0; step < mostSteps; ++step) {
    if (newtonStep(m_distortion.params(), std::numeric_limits<double>::infinity(), x, y, count,
                   idealX.data(), idealY.data(), move.data()) > 0)
      continue;
    std::copy_n(idealX.data(), count, x);
    std::copy_n(idealY.data(), count, y);
    return true;
  }
  return false;
}

}  // namespace hogelscope
