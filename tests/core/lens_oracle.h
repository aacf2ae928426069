// SPDX-License-Identifier: BSD-3-Clause
// An independent lens model for tests, written from docs/formulas.md, Distortion, only. It finds
// the inverse by walking.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>

/// The lens model; points of the plane z = 1 are complex numbers, x + iy.
class LensOracle {
 public:
  using Point = std::complex<double>;

  /// Takes the coefficients in OpenCV's order; k4 to k6 are those of the divisor.
  LensOracle(double k1, double k2, double p1, double p2, double k3, double k4 = 0, double k5 = 0,
             double k6 = 0)
      : m_k1(k1), m_k2(k2), m_p1(p1), m_p2(p2), m_k3(k3), m_k4(k4), m_k5(k5), m_k6(k6) {}

  [[nodiscard]] Point distort(Point p) const {
    const double x = p.real();
    const double y = p.imag();
    const double s = std::norm(p);
    const double radial = factor(s)[0];
    return {x * radial + 2 * m_p1 * x * y + m_p2 * (s + 2 * x * x),
            y * radial + m_p1 * (s + 2 * y * y) + 2 * m_p2 * x * y};
  }

  [[nodiscard]] double det(Point p) const {
    const auto [xx, xy, yy] = jacobian(p);
    return xx * yy - xy * xy;
  }

  struct Walk {
    enum class End { ray, fold, unclear } end;
    Point point;
    double smallestDet;
  };

  /// Walks dp/dt = J⁻¹ q from the origin to t = 1, the preimage of the segment to q, in steps over
  /// which det J changes by at most `change`.
  [[nodiscard]] Walk walk(Point q, double change = 0.01, double longestStep = 0.002) const {
    constexpr double onFold = 1e-5;
    Walk at{Walk::End::ray, 0, 1};
    double t = 0;
    double step = longestStep;
    double here = 1;
    while (t < 1) {
      step = std::min({2 * step, longestStep, 1 - t});
      Point next = stepped(at.point, q, step);
      while (!(std::abs(det(next) - here) <= change * here)) {
        step /= 2;
        if (step < 1e-16) return {Walk::End::unclear, at.point, here};
        next = stepped(at.point, q, step);
      }
      at.point = next;
      here = det(next);
      t = step == 1 - t ? 1 : t + step;
      at.smallestDet = std::min(at.smallestDet, here);
      if (here < onFold) {
        // The walk meets the fold at about t + 1e-10; both answers are valid if that is 1.
        at.end = t < 1 - 1e-6 ? Walk::End::fold : Walk::End::unclear;
        return at;
      }
    }
    // The walk passed so near a fold that the steps' error decides on which side.
    if (at.smallestDet < change / 10) at.end = Walk::End::unclear;
    return at;
  }

  /// Returns the root of distort(p) = q near `p`.
  [[nodiscard]] Point refined(Point p, Point q) const {
    for (int k = 0; k < 5; ++k) p += solved(p, q - distort(p));
    return p;
  }

 private:
  /// Returns the radial factor and its derivative by s.
  [[nodiscard]] std::array<double, 2> factor(double s) const {
    const double n = 1 + s * (m_k1 + s * (m_k2 + s * m_k3));
    const double dn = m_k1 + s * (2 * m_k2 + s * 3 * m_k3);
    const double d = 1 + s * (m_k4 + s * (m_k5 + s * m_k6));
    const double dd = m_k4 + s * (2 * m_k5 + s * 3 * m_k6);
    return {n / d, (dn * d - n * dd) / (d * d)};
  }
  /// Returns xx, xy = yx, yy.
  [[nodiscard]] std::array<double, 3> jacobian(Point p) const {
    const double x = p.real();
    const double y = p.imag();
    const double s = std::norm(p);
    const auto [radial, dRadial] = factor(s);
    return {radial + 2 * x * x * dRadial + 2 * m_p1 * y + 6 * m_p2 * x,
            2 * x * y * dRadial + 2 * m_p1 * x + 2 * m_p2 * y,
            radial + 2 * y * y * dRadial + 6 * m_p1 * y + 2 * m_p2 * x};
  }
  /// Returns J⁻¹ r at p.
  [[nodiscard]] Point solved(Point p, Point r) const {
    const auto [xx, xy, yy] = jacobian(p);
    const double d = xx * yy - xy * xy;
    return {(yy * r.real() - xy * r.imag()) / d, (xx * r.imag() - xy * r.real()) / d};
  }
  /// Performs a step of the classical Runge-Kutta method.
  [[nodiscard]] Point stepped(Point p, Point q, double h) const {
    const Point a = solved(p, q);
    const Point b = solved(p + h / 2 * a, q);
    const Point c = solved(p + h / 2 * b, q);
    const Point d = solved(p + h * c, q);
    return p + h / 6 * (a + 2.0 * b + 2.0 * c + d);
  }

  double m_k1, m_k2, m_p1, m_p2, m_k3, m_k4, m_k5, m_k6;
};

/// The fisheye model, whose inverse looks at one angle after another.
class FisheyeOracle {
 public:
  using Point = LensOracle::Point;
  using Walk = LensOracle::Walk;

  FisheyeOracle(double k1, double k2, double k3, double k4) : m_k{k1, k2, k3, k4} {}

  [[nodiscard]] Point distort(Point p) const {
    return std::abs(p) > 0 ? distorted(std::atan(std::abs(p))) / std::abs(p) * p : p;
  }

  [[nodiscard]] Walk walk(Point q) const {
    constexpr int steps = 20000;
    const double rightAngle = std::acos(0.0);
    double before = 0;
    for (int k = 1; k <= steps; ++k) {
      const double angle = rightAngle * k / steps;
      const double here = distorted(angle);
      if (!(here > before)) return {nearlyEnds(before, q), 0, 0};
      if (here >= std::abs(q)) return {Walk::End::ray, solved(angle, rightAngle / steps, q), 1};
      before = here;
    }
    return {nearlyEnds(before, q), 0, 0};
  }

 private:
  [[nodiscard]] double distorted(double angle) const {
    return angle + m_k[0] * std::pow(angle, 3) + m_k[1] * std::pow(angle, 5) +
           m_k[2] * std::pow(angle, 7) + m_k[3] * std::pow(angle, 9);
  }
  static Walk::End nearlyEnds(double end, Point q) {
    return std::abs(q) > end * 1.0001 ? Walk::End::fold : Walk::End::unclear;
  }
  /// Bisects the last step.
  [[nodiscard]] Point solved(double high, double step, Point q) const {
    double low = high - step;
    for (int halving = 0; halving < 80; ++halving) {
      const double middle = (low + high) / 2;
      (distorted(middle) < std::abs(q) ? low : high) = middle;
    }
    return std::abs(q) > 0 ? std::tan((low + high) / 2) / std::abs(q) * q : q;
  }

  std::array<double, 4> m_k;
};
