// SPDX-License-Identifier: BSD-3-Clause
#include "study/lens_outcomes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <utility>

#include "core/lens/batch_undistort.h"

namespace hogelscope {

namespace {

using Points = std::vector<Vec2>;

/// Calls cv::undistortPoints, or cv::fisheye::undistortPoints, for points of the plane z = 1.
Points byOpenCv(const Distortion& lens, const Points& distorted, int iterations) {
  std::vector<cv::Point2d> from;
  for (const Vec2& p : distorted) from.emplace_back(p.x, p.y);
  std::vector<cv::Point2d> to;
  const std::vector<double> coefficients = vectorOf(lens.params());
  const cv::TermCriteria steps(cv::TermCriteria::COUNT, iterations, 0);
  if (lens.fisheye() != nullptr)
    cv::fisheye::undistortPoints(from, to, cv::Matx33d::eye(), coefficients, cv::noArray(),
                                 cv::noArray(), steps);
  else
    cv::undistortPoints(from, to, cv::Matx33d::eye(), coefficients, cv::noArray(), cv::noArray(),
                        steps);
  Points ideal;
  for (const cv::Point2d& p : to) ideal.push_back({p.x, p.y});
  return ideal;
}

/// Performs plain Newton steps without safeguards, which may diverge.
Vec2 newton(const Distortion& lens, const Vec2& distorted) {
  constexpr int steps = 20;
  Vec2 ideal = distorted;
  for (int step = 0; step < steps; ++step) {
    const Vec2 here = lens.distort(ideal);
    const Vec2 error{distorted.x - here.x, distorted.y - here.y};
    const Jacobian j = lens.jacobian(ideal);
    const double det = j.xx * j.yy - j.xy * j.yx;
    ideal.x += (j.yy * error.x - j.xy * error.y) / det;
    ideal.y += (j.xx * error.y - j.yx * error.x) / det;
  }
  return ideal;
}

Points byNewton(const Distortion& lens, const Points& distorted, const Progress&) {
  Points ideal;
  for (const Vec2& p : distorted) ideal.push_back(newton(lens, p));
  return ideal;
}

Points byOurs(const Distortion& lens, const Points& distorted, const Progress& progress) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Vec2& p : distorted) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  BatchUndistort(lens, progress).undistort(x.data(), y.data(), int(x.size()));
  Points ideal;
  for (std::size_t k = 0; k < x.size(); ++k) ideal.push_back({x[k], y[k]});
  return ideal;
}

InverseMethod openCv(int iterations) {
  return {"OpenCV " + std::to_string(iterations), false,
          [iterations](const Distortion& lens, const Points& distorted, const Progress&) {
            return byOpenCv(lens, distorted, iterations);
          }};
}

}  // namespace

const std::vector<InverseMethod>& inverseMethods() {
  static const std::vector<InverseMethod> methods{
      openCv(5), openCv(20), openCv(200), {"Newton 20", false, byNewton}, {"ours", true, byOurs}};
  return methods;
}

const std::array<std::string, outcomeCount>& outcomeNames() {
  static const std::array<std::string, outcomeCount> names{"right", "no_ray", "inexact", "diverged",
                                                           "wrong_root"};
  return names;
}

std::size_t LensOutcomes::points() const {
  return std::accumulate(count.begin(), count.end(), std::size_t{0});
}

Outcome LensOutcomes::worst() const {
  std::size_t at = outcomeCount - 1;
  while (at > 0 && count[at] == 0) --at;
  return Outcome(at);
}

LensTrial::LensTrial(const LensKey& lens, int columns, int rows, Progress progress)
    : m_lens(lens), m_progress(std::move(progress)) {
  const Distortion distortion(lens.distortion);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      throwIfCancelled(m_progress);
      const double px = double(column) * (lens.res[0] - 1) / (columns - 1);
      const double py = double(row) * (lens.res[1] - 1) / (rows - 1);
      m_distorted.push_back(
          {(px - lens.centre.x) / lens.focalLength.x, (py - lens.centre.y) / lens.focalLength.y});
      m_right.push_back(distortion.undistort(m_distorted.back()));
    }
  }
}

double LensTrial::pixels(const Vec2& from, const Vec2& to) const {
  return std::hypot(m_lens.focalLength.x * (to.x - from.x), m_lens.focalLength.y * (to.y - from.y));
}

Outcome LensTrial::outcome(std::size_t at, const Vec2& ideal, bool saysNoRay) const {
  constexpr double rootResidual = 1e-3;  // px
  constexpr double sameRoot = 1;  // px, because near a fold the residual determines the root poorly
  const Distortion lens(m_lens.distortion);
  const Vec2& distorted = m_distorted[at];
  if (!(std::isfinite(ideal.x) && std::isfinite(ideal.y)))
    return saysNoRay && !m_right[at] ? Outcome::noRay : Outcome::diverged;
  const double residual = pixels(distorted, lens.distort(ideal));
  if (residual <= rootResidual)
    return m_right[at] && pixels(*m_right[at], ideal) <= sameRoot ? Outcome::right
                                                                  : Outcome::wrongRoot;
  // Every method starts at the distorted point itself.
  return residual < pixels(distorted, lens.distort(distorted)) ? Outcome::inexact
                                                               : Outcome::diverged;
}

LensOutcomes LensTrial::outcomes(const InverseMethod& method) const {
  const Distortion lens(m_lens.distortion);
  const std::vector<Vec2> ideal = method.undistort(lens, m_distorted, m_progress);
  LensOutcomes all;
  all.each.reserve(ideal.size());
  for (std::size_t at = 0; at < ideal.size(); ++at) {
    const Outcome here = outcome(at, ideal[at], method.saysNoRay);
    ++all.count[std::size_t(here)];
    all.each.push_back(here);
    if (here == Outcome::noRay) continue;
    const double residual = pixels(m_distorted[at], lens.distort(ideal[at]));
    all.worstResidual = std::isfinite(residual) ? std::max(all.worstResidual, residual)
                                                : std::numeric_limits<double>::infinity();
  }
  return all;
}

}  // namespace hogelscope
