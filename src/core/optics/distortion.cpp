// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion and its certified inverse: Newton from the centre, each step within the ball in
// which the Newton–Kantorovich theorem says that there is one root and no fold.
#include "core/optics/distortion.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

double det(const Jacobian& j) {
  return j.xx * j.yy - j.xy * j.yx;
}

Vec2 solve(const Jacobian& j, const Vec2& r) {
  const double d = det(j);
  return {(j.yy * r.x - j.xy * r.y) / d, (j.xx * r.y - j.yx * r.x) / d};
}

/// Returns the norm of the inverse of `j`: its largest singular value over |det|.
double inverseNorm(const Jacobian& j) {
  const double sum = std::hypot(j.xx + j.yy, j.yx - j.xy);
  const double difference = std::hypot(j.xx - j.yy, j.yx + j.xy);
  return (sum + difference) / 2 / std::abs(det(j));
}

double norm(const Vec2& a) {
  return std::hypot(a.x, a.y);
}

}  // namespace

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

/// The field |p|²ⁿ p has a second derivative of norm 2n(2n+1) |p|²ⁿ⁻¹, the tangential terms are
/// quadratic with at most 6 |(p1, p2)|.
double Distortion::secondDerivativeBound(double radius) const {
  const auto& [k1, k2, p1, p2, k3] = m_params;
  const double r2 = radius * radius;
  return radius * (6 * std::abs(k1) + r2 * (20 * std::abs(k2) + r2 * 42 * std::abs(k3))) +
         6 * std::hypot(p1, p2);
}

/// Makes a few Newton steps from inside the root's basin while the residual shrinks.
Vec2 Distortion::polish(Vec2 ideal, const Vec2& distorted) const {
  const auto residualAt = [&](const Vec2& p) {
    const Vec2 d = distort(p);
    return Vec2{distorted.x - d.x, distorted.y - d.y};
  };
  const double rounding = 2e-16 * norm(distorted);
  Vec2 residual = residualAt(ideal);
  double size = norm(residual);
  for (int step = 0; step < 20 && size > rounding; ++step) {
    const Vec2 move = solve(jacobian(ideal), residual);
    const Vec2 next{ideal.x + move.x, ideal.y + move.y};
    residual = residualAt(next);
    const double nextSize = norm(residual);
    if (!(nextSize < size)) break;
    ideal = next;
    size = nextSize;
  }
  return ideal;
}

std::optional<Vec2> Distortion::undistort(const Vec2& distorted) const {
  if (isIdentity()) return distorted;
  // Kantorovich: h = β K η ≤ 1/2 keeps the whole step on one branch; β bounds the inverse
  // Jacobian, η is Newton's first move, K bounds the second derivative in the ball 2η.
  constexpr double certain = 0.45;
  constexpr double shortestStep = 1e-13;  // of `reached`: a nearer point counts as on the fold
  Vec2 ideal{0, 0};
  double reached = 0;  // the part of the segment whose preimage is known
  double step = 1;
  while (reached < 1) {
    const Jacobian j = jacobian(ideal);
    const double beta = inverseNorm(j);
    if (!(det(j) > 0 && std::isfinite(beta))) return std::nullopt;
    const Vec2 here = distort(ideal);
    step = std::min(2 * step, 1 - reached);
    for (;; step /= 2) {
      if (!(step > shortestStep * reached)) return std::nullopt;
      const double t = reached + step;
      const Vec2 move = solve(j, {t * distorted.x - here.x, t * distorted.y - here.y});
      const double eta = norm(move);
      if (beta * secondDerivativeBound(norm(ideal) + 2 * eta) * eta <= certain) break;
    }
    reached = step == 1 - reached ? 1 : reached + step;
    ideal = polish(ideal, {reached * distorted.x, reached * distorted.y});
  }
  return ideal;
}

}  // namespace hogelscope
