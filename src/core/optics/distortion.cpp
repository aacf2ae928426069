// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion: the model, its derivatives and their bounds.
#include "core/optics/distortion.h"

#include <algorithm>

#include "core/optics/lens_branch.h"

namespace hogelscope {

void describe(ParameterVisitor& v, DistortionParams& p) {
  auto& [k1, k2, p1, p2, k3] = p;
  v.group("distortion", "Lens distortion of the camera: Brown-Conrady, OpenCV's coefficients.");
  v.field("k1", k1, {-10, 10, 0.001, false, -1, 1}, "",
          "Radial, r²: below 0 barrel, above 0 pincushion.");
  v.field("k2", k2, {-10, 10, 0.001, false, -1, 1}, "", "Radial, r⁴.");
  v.field("p1", p1, {-10, 10, 0.001, false, -0.2, 0.2}, "", "Tangential, vertical.");
  v.field("p2", p2, {-10, 10, 0.001, false, -0.2, 0.2}, "", "Tangential, horizontal.");
  v.field("k3", k3, {-10, 10, 0.001, false, -1, 1}, "", "Radial, r⁶.");
}

Vec2 Distortion::distort(const Vec2& p) const {
  const auto& [k1, k2, p1, p2, k3] = m_params;
  const auto [x, y] = p;
  const double r2 = x * x + y * y;
  const double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  return {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
          y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

Jacobian Distortion::jacobian(const Vec2& p) const {
  const auto& [k1, k2, p1, p2, k3] = m_params;
  const auto [x, y] = p;
  const double r2 = x * x + y * y;
  const double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  const double slope = 2 * k1 + 4 * k2 * r2 + 6 * k3 * r2 * r2;  // d radial / dr, over r
  const double mixed = slope * x * y + 2 * p1 * x + 2 * p2 * y;
  return {radial + slope * x * x + 2 * p1 * y + 6 * p2 * x, mixed, mixed,
          radial + slope * y * y + 6 * p1 * y + 2 * p2 * x};
}

/// With P = (p2, p1) and h' the radial factor as a function of r²/2, the model is the gradient of
/// h + r² P·x. Along a unit vector at an angle of cosine c to the radius the third, fourth and
/// fifth derivatives of that are h''' r³ c³ + 3 h'' r c and at most 6 |P|; h'''' r⁴ c⁴ + 6 h''' r²
/// c² + 3 h''; 10 h'''' r³ c³ + 15 h''' r c. These are also the derivatives' norms, as they are
/// symmetric.
DerivativeBounds Distortion::derivativeBounds(double radius, double within) const {
  const auto [k1, k2, p1, p2, k3] = m_params;
  const double r2 = radius * radius;
  const double h2 = 2 * k1 + r2 * (4 * k2 + r2 * 6 * k3);
  const double h3 = 8 * k2 + r2 * 24 * k3;
  const double h4 = 48 * k3;
  const double largest = radius + within;
  const double fourth = largest * (120 * std::abs(k2) + 840 * std::abs(k3) * largest * largest);
  const double third = std::max({std::abs(3 * h2), std::abs(3 * h2 + 6 * h3 * r2),
                                 std::abs(3 * h2 + r2 * (6 * h3 + r2 * h4))});
  const double second =
      radius * std::max(std::abs(3 * h2), std::abs(3 * h2 + h3 * r2)) + 6 * m_tangential;
  const double change = within * (third + within / 2 * fourth);
  return {second + change, third + within * fourth, change};
}

double Distortion::safeStep(double radius, double margin, double longest) const {
  const DerivativeBounds here = derivativeBounds(radius, 0);
  const double guess =
      std::min({margin / here.second, std::sqrt(std::max(0.0, margin) / here.third), longest});
  return std::min(guess, margin / derivativeBounds(radius, guess).second);
}

std::optional<Vec2> Distortion::undistort(const Vec2& distorted) const {
  if (isIdentity()) return distorted;
  const Branch branch = followBranch(*this, {distorted, 0}, {});
  if (branch.kind != Branch::Kind::ray) return std::nullopt;
  return branch.ideal;
}

}  // namespace hogelscope
