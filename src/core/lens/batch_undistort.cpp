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

/// The number of points that are iterated together, small enough for the first-level cache.
constexpr int pointsAtOnce = 128;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double squaredNorm(const Vec2& a) {
  return a.x * a.x + a.y * a.y;
}

/// Points whose root is certainly the right one if Newton finds it nearer to the centre than some
/// radius.
class Candidates {
 public:
  Candidates(double* x, double* y) : m_x(x), m_y(y) {}

  void add(int index, const Vec2& guess, double farthest) {
    const auto at = std::size_t(m_count++);
    m_index[at] = index;
    m_farthest[at] = farthest;
    m_distortedX[at] = m_x[index];
    m_distortedY[at] = m_y[index];
    m_idealX[at] = guess.x;
    m_idealY[at] = guess.y;
  }

  /// Replaces the points by the roots that are found; `isDone` of these becomes true.
  void solve(const DistortionParams& lens, std::array<bool, pointsAtOnce>& isDone) {
    constexpr int mostSteps = 20;
    if (m_count == 0) return;
    for (int step = 0; step < mostSteps; ++step)
      if (newtonStep(lens, m_distortedX.data(), m_distortedY.data(), m_count, m_idealX.data(),
                     m_idealY.data(), m_move.data()) == 0)
        break;
    for (std::size_t at = 0; at < std::size_t(m_count); ++at) {
      const Vec2 root{m_idealX[at], m_idealY[at]};
      if (!(m_move[at] < shortMoveSquared && squaredNorm(root) < m_farthest[at] * m_farthest[at]))
        continue;
      m_x[m_index[at]] = root.x;
      m_y[m_index[at]] = root.y;
      isDone[std::size_t(m_index[at])] = true;
    }
    m_count = 0;
  }

 private:
  double* m_x;
  double* m_y;
  int m_count = 0;
  std::array<int, pointsAtOnce> m_index;
  std::array<double, pointsAtOnce> m_farthest, m_distortedX, m_distortedY, m_idealX, m_idealY,
      m_move;
};

/// Replaces distorted points of a fisheye. Newton's steps are made together for many points; those
/// that it does not bring near a root before the lens' end are solved one by one.
void undistortFisheye(const Fisheye& lens, double* x, double* y, int count) {
  constexpr int steps = 4;  // the few that need more are solved one by one
  std::array<double, pointsAtOnce> distance, angle;
  for (int first = 0; first < count; first += pointsAtOnce) {
    const int n = std::min(pointsAtOnce, count - first);
    for (int k = 0; k < n; ++k) {
      const auto at = std::size_t(k);
      const double px = x[first + k], py = y[first + k];
      distance[at] = std::sqrt(px * px + py * py);
      angle[at] = std::min(distance[at], lens.end());
    }
    for (int step = 0; step < steps; ++step)
      for (std::size_t k = 0; k < std::size_t(n); ++k)
        angle[k] -= (lens.distorted(angle[k]) - distance[k]) / lens.slope(angle[k]);
    for (int k = 0; k < n; ++k) {
      const auto at = std::size_t(k);
      const double error = lens.distorted(angle[at]) - distance[at];
      const bool isRoot =
          angle[at] >= 0 && angle[at] < lens.end() && std::abs(error) <= 4e-16 * distance[at];
      if (!isRoot) angle[at] = lens.angle(distance[at]);
      const double factor = distance[at] > 0 ? std::tan(angle[at]) / distance[at] : 1;
      x[first + k] *= factor;
      y[first + k] *= factor;
    }
  }
}

}  // namespace

/// Marches outwards as long as the least eigenvalue's bound, which changes by at most the second
/// derivative's bound per length, stays positive.
BatchUndistort::BatchUndistort(const Distortion& distortion, Progress progress)
    : m_distortion(distortion), m_progress(std::move(progress)), m_fans(distortion) {
  if (m_distortion.fisheye() != nullptr) return;
  const double end = m_distortion.marchEnd();
  double radius = 0;
  while (radius < end) {
    throwIfCancelled(m_progress);
    const double longest = std::min(0.2 * radius + 0.05, end - radius);
    const double step = m_distortion.safeStep(radius, 0.9 * leastEigenvalue(radius), longest);
    if (!(step > 1e-9 * (1 + radius))) break;
    radius += step;
  }
  m_certainRadius = radius;
  // The least radial part of the model at that radius.
  const DistortionParams& lens = m_distortion.params();
  m_certainDistorted = std::clamp(
      m_distortion.radial(radius).value - 3 * radius * radius * std::hypot(lens.p1, lens.p2), 0.0,
      Distortion::farthest);
}

/// Returns a lower bound over the circle: along and across the radius for the radial terms, less
/// 6 |(p1, p2)| r, the most that the tangential ones can subtract.
double BatchUndistort::leastEigenvalue(double radius) const {
  const RadialTerms radial = m_distortion.radial(radius);
  const DistortionParams& lens = m_distortion.params();
  return std::min(radial.across, radial.slope) - 6 * std::hypot(lens.p1, lens.p2) * radius;
}

void BatchUndistort::undistort(double* x, double* y, int count) const {
  if (m_distortion.isIdentity()) return;
  if (m_distortion.fisheye() != nullptr)
    return undistortFisheye(*m_distortion.fisheye(), x, y, count);
  for (int k = 0; k < count; k += pointsAtOnce)
    undistortBatch(x + k, y + k, std::min(pointsAtOnce, count - k));
}

void BatchUndistort::undistortBatch(double* x, double* y, int count) const {
  const DistortionParams& lens = m_distortion.params();
  std::array<bool, pointsAtOnce> isDone{};
  const auto setNone = [&](int k) {
    x[k] = y[k] = none;
    isDone[std::size_t(k)] = true;
  };
  const auto forTheRest = [&](auto&& work) {
    for (int k = 0; k < count; ++k)
      if (!isDone[std::size_t(k)]) work(k, Vec2{x[k], y[k]});
  };
  Candidates candidates(x, y);
  forTheRest([&](int k, const Vec2& q) {
    if (squaredNorm(q) < m_certainDistorted * m_certainDistorted)
      candidates.add(k, q, m_certainRadius);
  });
  candidates.solve(lens, isDone);
  // Most lenses are certain everywhere, and continuing would cost them a tenth of their time.
  if (std::all_of(isDone.begin(), isDone.begin() + count, [](bool is) { return is; })) return;
  forTheRest([&](int k, const Vec2& q) {
    constexpr double farthest = Distortion::farthest;
    if (!(squaredNorm(q) <= farthest * farthest)) return setNone(k);
    const LensSector& sector = m_fans.sector(q);
    const double distance = std::sqrt(squaredNorm(q));
    if (distance >= sector.dark) return setNone(k);
    if (distance > 0 && distance < sector.distorted)
      candidates.add(k, guessInSector(m_distortion, sector, q), sector.ideal);
  });
  candidates.solve(lens, isDone);
  std::array<BranchLine, pointsAtOnce> start;
  forTheRest([&](int k, const Vec2& q) {
    const LensFans::Place place = m_fans.find(q, m_progress);
    start[std::size_t(k)] = place.line;
    if (place.kind == LensFans::Place::Kind::none) return setNone(k);
    if (place.kind == LensFans::Place::Kind::ray)
      candidates.add(k, place.line.ideal, std::numeric_limits<double>::infinity());
  });
  candidates.solve(lens, isDone);
  forTheRest([&](int k, const Vec2& q) {
    const Branch branch = followBranch(m_distortion, {q, 0}, m_progress, start[std::size_t(k)]);
    const bool isRay = branch.kind == Branch::Kind::ray;
    x[k] = isRay ? branch.ideal.x : none;
    y[k] = isRay ? branch.ideal.y : none;
  });
}

}  // namespace hogelscope
