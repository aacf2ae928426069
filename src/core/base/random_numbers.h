// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers that are the same with every standard library, unlike those of
// std::*_distribution.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace hogelscope {

/// The 64-bit Mersenne Twister, whose output the C++ standard fixes.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : m_engine(seed) {}

  /// Uniform in [0, 1): the generator's upper 53 bits.
  double unit() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; }

  /// Standard normal, by Box and Muller (1958); calls unit() twice.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - unit()));
    return radius * std::cos(2 * std::numbers::pi * unit());
  }

 private:
  std::mt19937_64 m_engine;
};

}  // namespace hogelscope
