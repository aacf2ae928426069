// SPDX-License-Identifier: BSD-3-Clause
// The axes of charts and their ticks, on round values.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// Values [low, high] lie along [from, to], which may fall; low < high.
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

/// The largest of 1, 2, 5 times a power of ten that is at most `value`, which is > 0.
double roundedDown(double value);
/// The smallest of 1, 2, 5 times a power of ten of which at most `most` steps fit into `range`.
double tickStep(double range, int most);
/// The multiples of that step within the axis.
std::vector<Tick> linearTicks(const Axis& axis, int most);
/// Ticks at 1, 2, … 9 times the powers of ten of an axis of log10 of the values. Those with a text
/// are at least `room` apart.
std::vector<Tick> logarithmicTicks(const Axis& axis, double room);

}  // namespace hogelscope
