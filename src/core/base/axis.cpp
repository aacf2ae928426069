// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/axis.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

namespace {

double decadeOf(double value) {
  return std::pow(10, std::floor(std::log10(value)));
}

std::string textOf(double value, int decade) {
  return std::abs(decade) > 5 ? withMinus(numberText(value)) : rounded(value, std::max(0, -decade));
}

}  // namespace

double tickStep(double range, int most) {
  const double decade = decadeOf(range / most);
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade * most >= range) return factor * decade;
  return 10 * decade;
}

std::vector<Tick> linearTicks(const Axis& axis, int most) {
  const double step = tickStep(axis.high - axis.low, most);
  const int digits = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> ticks;
  const double slack = 1e-6 * step;
  for (double k = std::ceil((axis.low - slack) / step); k * step <= axis.high + slack; ++k)
    ticks.push_back({k * step, withMinus(rounded(k * step, digits))});
  return ticks;
}

std::vector<Tick> logarithmicTicks(const Axis& axis, double room) {
  const double decade = std::abs(axis.to - axis.from) / (axis.high - axis.low);
  const int every = std::max(1, int(std::ceil(room / decade)));
  // 2 and 5 divide a decade into about equal parts; log10(2) is the smallest.
  const bool isDivided = decade * std::log10(2.0) >= room;
  const int digits = axis.high - axis.low > 12 ? 1 : 9;  // more minor ticks would merge
  std::vector<Tick> ticks;
  constexpr double slack = 1e-9;
  for (int power = int(std::floor(axis.low)); power <= axis.high + slack; ++power)
    for (int digit = 1; digit <= digits; ++digit) {
      const double value = digit * std::pow(10.0, power);
      const double logarithm = std::log10(value);
      if (logarithm < axis.low - slack || logarithm > axis.high + slack) continue;
      const bool hasText =
          digit == 1 ? power % every == 0 : isDivided && (digit == 2 || digit == 5);
      ticks.push_back({value, hasText ? textOf(value, power) : ""});
    }
  return ticks;
}

}  // namespace hogelscope
