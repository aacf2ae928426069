// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers that are identical with every standard library, unlike those of
// std::*_distribution.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace hogelscope {

/// Returns a number of [0, 1) made of the upper 53 bits.
inline double unitOf(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// Returns a standard normal number made of two uniform ones of [0, 1), by Box and Muller (1958).
inline double normalOf(double u, double v) {
  return std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * std::numbers::pi * v);
}

/// A random number generator: the 64-bit Mersenne Twister, defined by the C++ standard.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : m_engine(seed) {}

  /// Returns a uniform number of [0, 1).
  double unit() { return unitOf(m_engine()); }

  /// Returns a standard normal number, by Box and Muller (1958); calls unit() twice.
  double normal() {
    const double u = unit();
    return normalOf(u, unit());
  }

 private:
  std::mt19937_64 m_engine;
};

}  // namespace hogelscope
