// SPDX-License-Identifier: BSD-3-Clause
// The axes of charts and their ticks, on round values.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// An axis with values [low, high] at positions [from, to]; to < from is allowed; low < high.
struct Axis {
  double low = 0;
  double high = 1;
  double from = 0;
  double to = 1;
  [[nodiscard]] double at(double value) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

struct Tick {
  double value = 0;
  std::string text;  ///< UTF-8 with U+2212 as minus; empty for a minor tick
};

/// Returns the smallest of 1, 2, 5 times a power of ten of which at most `most` steps fit `range`.
double tickStep(double range, int most);
/// Returns ticks at the multiples of tickStep() within the axis.
std::vector<Tick> linearTicks(const Axis& axis, int most);
/// Returns ticks at 1, 2, … 9 times the powers of ten, for an axis of log10 of the values. Ticks
/// with a text are at least `room` apart.
std::vector<Tick> logarithmicTicks(const Axis& axis, double room);

}  // namespace hogelscope
