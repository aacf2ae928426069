// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers for tests, identical with every standard library.
#pragma once

#include <cstdint>
#include <random>

/// A generator. std::uniform_real_distribution is avoided because libraries may draw differently.
class Random {
 public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}
  /// Returns a number of [min, max).
  double uniform(double min, double max) {
    return min + (max - min) * static_cast<double>(m_engine() >> 11) * 0x1p-53;
  }
  /// Returns an integer of [min, max], both included.
  int integer(int min, int max) {
    const std::int64_t count = std::int64_t{max} - min + 1;
    return static_cast<int>(
        min + static_cast<std::int64_t>(m_engine() % static_cast<std::uint64_t>(count)));
  }
  bool flip() { return integer(0, 1) == 1; }

 private:
  std::mt19937_64 m_engine;
};
