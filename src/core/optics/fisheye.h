// SPDX-License-Identifier: BSD-3-Clause
// The fisheye model of cv::fisheye, "equidistant" in ROS: a ray at the angle θ to the axis is
// imaged at θ_d = θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸) from the centre, in the plane z = 1's units
// (docs/formulas.md, Distortion).
#pragma once

#include <array>
#include <numbers>

namespace hogelscope {

class Fisheye {
 public:
  explicit Fisheye(const std::array<double, 4>& k);

  [[nodiscard]] double distorted(double angle) const {
    const double s = angle * angle;
    return angle * (1 + s * (m_k[0] + s * (m_k[1] + s * (m_k[2] + s * m_k[3]))));
  }
  /// Returns dθ_d/dθ.
  [[nodiscard]] double slope(double angle) const {
    const double s = angle * angle;
    return 1 + s * (3 * m_k[0] + s * (5 * m_k[1] + s * (7 * m_k[2] + s * 9 * m_k[3])));
  }
  /// Returns the angle at which a ray is imaged at the distance `distorted` ≥ 0; NaN where none
  /// nearer than the fold and than 90° is. The residual is a few units of rounding.
  [[nodiscard]] double angle(double distorted) const;

  /// Angles up to which θ_d grows: that of the fold, or 90°, where no fold is before.
  [[nodiscard]] double end() const { return m_end; }
  [[nodiscard]] bool folds() const { return m_end < rightAngle; }
  /// θ_d there: pixels from here outwards have no ray.
  [[nodiscard]] double distortedEnd() const { return m_distortedEnd; }

  static constexpr double rightAngle = std::numbers::pi / 2;

 private:
  std::array<double, 4> m_k;
  double m_end = rightAngle;
  double m_distortedEnd = 0;
};

}  // namespace hogelscope
