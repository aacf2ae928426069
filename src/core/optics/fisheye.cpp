// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/fisheye.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/polynomial.h"

namespace hogelscope {

namespace {

constexpr int untilRounding = 200;

}  // namespace

Fisheye::Fisheye(const std::array<double, 4>& k) : m_k(k) {
  const std::vector<double> folds =  // of the slope as a function of θ²
      signChanges({1, 3 * k[0], 5 * k[1], 7 * k[2], 9 * k[3]}, rightAngle * rightAngle);
  if (!folds.empty()) m_end = std::sqrt(folds.front());
  m_distortedEnd = distorted(m_end);
}

/// Newton's method within bounds that contain the root.
double Fisheye::angle(double distance) const {
  if (!(distance < m_distortedEnd)) return std::numeric_limits<double>::quiet_NaN();
  double low = 0;
  double high = m_end;
  double at = std::min(distance, m_end / 2);
  for (int step = 0; step < untilRounding; ++step) {
    const double error = distorted(at) - distance;
    (error < 0 ? low : high) = at;
    double next = at - error / slope(at);
    if (!(next > low && next < high)) next = (low + high) / 2;
    const bool isNear = std::abs(next - at) <= 1e-15 * at;
    at = next;
    if (isNear || !(low < high)) break;
  }
  return at;
}

}  // namespace hogelscope
