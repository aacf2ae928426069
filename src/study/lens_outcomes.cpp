// SPDX-License-Identifier: BSD-3-Clause
#include "study/lens_outcomes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hogelscope {

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
