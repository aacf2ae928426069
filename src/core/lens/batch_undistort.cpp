// SPDX-License-Identifier: BSD-3-Clause
// The inverse of a lens for many points: plain Newton where any root is the right one.
#include "core/lens/batch_undistort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/lens/lens_steps.h"

namespace hogelscope {

namespace {

/// Points that are iterated together: small enough for the first-level cache.
constexpr int batchSize = 128;

/// Newton's error is squared by the next step: after a move this short it is below rounding.
constexpr double shortMoveSquared = 1e-18;

double squaredNorm(const Vec2& a) {
  return a.x * a.x + a.y * a.y;
}

}  // namespace

/// Marches outwards as long as the least eigenvalue's bound, which changes by at most the second
/// derivative's bound per length, stays positive.
BatchUndistort::BatchUndistort(const Distortion& distortion, Progress progress)
    : m_distortion(distortion), m_progress(std::move(progress)) {
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
  for (int k = 0; k < count; k += batchSize)
    undistortBatch(x + k, y + k, std::min(batchSize, count - k));
}

void BatchUndistort::undistortBatch(double* x, double* y, int count) const {
  constexpr int mostSteps = 20;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::array<double, batchSize> idealX;
  std::array<double, batchSize> idealY;
  std::array<double, batchSize> move;
  std::copy_n(x, count, idealX.data());
  std::copy_n(y, count, idealY.data());
  for (int step = 0; step < mostSteps; ++step)
    if (newtonStep(m_distortion.params(), m_certainDistorted, x, y, count, idealX.data(),
                   idealY.data(), move.data()) == 0)
      break;
  for (int k = 0; k < count; ++k) {
    const auto at = std::size_t(k);
    const Vec2 distorted{x[k], y[k]};
    Vec2 ideal{idealX[at], idealY[at]};
    const bool isCertain = squaredNorm(distorted) < m_certainDistorted * m_certainDistorted &&
                           squaredNorm(ideal) < m_certainRadius * m_certainRadius &&
                           move[at] < shortMoveSquared;
    if (!isCertain) {
      hearStop(m_progress);
      ideal = m_distortion.undistort(distorted).value_or(Vec2{none, none});
    }
    x[k] = ideal.x;
    y[k] = ideal.y;
  }
}

}  // namespace hogelscope
