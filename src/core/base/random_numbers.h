// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers that are the same with every standard library, unlike those of
// std::*_distribution.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace hogelscope {

/// A number of [0, 1) made of the upper 53 bits.
inline double unitOf(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// A standard normal number made of two uniform ones of [0, 1), by Box and Muller (1958).
inline double normalOf(double u, double v) {
  return std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * std::numbers::pi * v);
}

/// The 64-bit Mersenne Twister, whose output the C++ standard fixes.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : m_engine(seed) {}

  /// Uniform in [0, 1).
  double unit() { return unitOf(m_engine()); }

  /// Standard normal, by Box and Muller (1958); calls unit() twice.
  double normal() {
    const double u = unit();
    return normalOf(u, unit());
  }

 private:
  std::mt19937_64 m_engine;
};

}  // namespace hogelscope
