// SPDX-License-Identifier: BSD-3-Clause
// The radial factor g = (1 + k1 s + k2 s² + k3 s³) / (1 + k4 s + k5 s² + k6 s³), s = r², of the
// rational lens model, with its derivatives at a point or over a range (docs/formulas.md,
// Distortion).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace hogelscope {

/// A range of numbers that encloses results. Rounding is not added: bounds from it are used with
/// margins that are larger.
struct Enclosure {
  double low = 0;
  double high = 0;

  Enclosure(double value = 0) : low(value), high(value) {}  // NOLINT: implicit conversion
  Enclosure(double from, double to) : low(from), high(to) {}

  /// Returns the largest |number| in it.
  [[nodiscard]] double size() const { return std::max(std::abs(low), std::abs(high)); }
  /// Returns the least |number| in it.
  [[nodiscard]] double least() const { return std::max({0.0, low, -high}); }
};

inline Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  return {a.low + b.low, a.high + b.high};
}

inline Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  return {a.low - b.high, a.high - b.low};
}

inline Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  const auto [least, most] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {least, most};
}

/// The divisor must not contain 0.
inline Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  return a * Enclosure(1 / b.high, 1 / b.low);
}

/// The factor of one lens.
struct RadialFraction {
  std::array<double, 3> above{};  ///< k1, k2, k3
  std::array<double, 3> below{};  ///< k4, k5, k6

  /// Returns the least |divisor| over a range, or less; 0 if there may be a pole in it.
  [[nodiscard]] double leastDivisor(const Enclosure& s) const { return cubic(below, s)[0].least(); }

  /// Returns the coefficients of the factor's Taylor series at `s`: the value, and the n-th
  /// derivative by s over n!. With a range for `s`, in which no pole may be, each is a range that
  /// contains those of all its values.
  template <class Number>
  [[nodiscard]] std::array<Number, 5> series(const Number& s) const {
    const std::array<Number, 4> n = cubic(above, s);
    const std::array<Number, 4> d = cubic(below, s);
    std::array<Number, 5> g;
    g[0] = n[0] / d[0];
    g[1] = (n[1] - d[1] * g[0]) / d[0];
    g[2] = (n[2] - d[1] * g[1] - d[2] * g[0]) / d[0];
    g[3] = (n[3] - d[1] * g[2] - d[2] * g[1] - d[3] * g[0]) / d[0];
    g[4] = (Number(0) - d[1] * g[3] - d[2] * g[2] - d[3] * g[1]) / d[0];
    return g;
  }

 private:
  static std::array<double, 4> cubic(const std::array<double, 3>& k, double s) {
    const auto [a, b, c] = k;
    return {1 + s * (a + s * (b + s * c)), a + s * (2 * b + s * 3 * c), b + s * 3 * c, c};
  }
  /// Expands around the middle, which leaves less room than a sum of ranges would.
  static std::array<Enclosure, 4> cubic(const std::array<double, 3>& k, const Enclosure& s) {
    const double away = (s.high - s.low) / 2;
    const auto [a, b, c, d] = cubic(k, s.low + away);
    const auto around = [](double value, double most) {
      return Enclosure(value - most, value + most);
    };
    return {around(a, away * (std::abs(b) + away * (std::abs(c) + away * std::abs(d)))),
            around(b, away * (2 * std::abs(c) + away * 3 * std::abs(d))),
            around(c, away * 3 * std::abs(d)), d};
  }
};

}  // namespace hogelscope
