// SPDX-License-Identifier: BSD-3-Clause
// A logarithmic axis: ticks at 1, 2, … 9 times a power of ten.
#include "chart/log_axis.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

constexpr double tolerance = 1e-9;  // of a logarithm, where an end is a tick

}  // namespace

LogAxis::LogAxis(double least, double most, double from, double to)
    : m_least(std::log10(least)), m_most(std::log10(most)), m_from(from), m_to(to) {
  const double missing = std::max(0.0, 1 - (m_most - m_least));
  m_least -= missing / 2;
  m_most += missing / 2;
}

double LogAxis::place(double value) const {
  return m_from + (std::log10(value) - m_least) / (m_most - m_least) * (m_to - m_from);
}

bool LogAxis::holds(double value) const {
  const double logarithm = std::log10(value);
  return logarithm >= m_least - tolerance && logarithm <= m_most + tolerance;
}

bool LogAxis::isLabelled(int decade, int digit, double room) const {
  const double pointsPerDecade = std::abs(m_to - m_from) / (m_most - m_least);
  if (digit == 1) {
    const int every = static_cast<int>(std::ceil(room / pointsPerDecade));
    return decade % every == 0;
  }
  // 2 and 5 divide a decade into about equal parts, of which log10(2) is the least.
  return (digit == 2 || digit == 5) && pointsPerDecade * std::log10(2.0) >= room;
}

std::vector<Tick> LogAxis::ticks(double room) const {
  std::vector<Tick> all;
  const int first = static_cast<int>(std::floor(m_least));
  const int last = static_cast<int>(std::floor(m_most + tolerance));
  const int digits = last - first > 12 ? 1 : 9;  // more minor ticks would be a grey bar
  for (int decade = first; decade <= last; ++decade)
    for (int digit = 1; digit <= digits; ++digit) {
      const double value = digit * std::pow(10.0, decade);
      if (holds(value)) all.push_back({value, place(value), isLabelled(decade, digit, room)});
    }
  return all;
}

}  // namespace hogelscope
