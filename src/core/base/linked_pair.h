// SPDX-License-Identifier: BSD-3-Clause
// Two numbers that keep their ratio while one of them is edited.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "core/base/parameters.h"

namespace hogelscope {

/// The ratio is not taken from numbers that were rounded here, which would drift in a drag, but
/// anew from values that others have set.
class LinkedPair {
 public:
  /// Changes the other one of two `values` after an edit of one; `before` are both before it. If
  /// one of two different numbers was left out, so below the range, nothing changes.
  template <class Number>
  void follow(const Range& range, std::span<const Number> before, std::span<Number> values) {
    const std::array old{double(before[0]), double(before[1])};
    if (old[0] != old[1] && std::min(old[0], old[1]) < range.min) return;
    if (old != m_last) m_ratio = old[0] == old[1] ? 1 : old[1] / old[0];
    const std::size_t edited = values[0] != before[0] ? 0 : 1;
    double other = edited == 0 ? values[0] * m_ratio : values[1] / m_ratio;
    if (values[edited] >= range.min) other = std::clamp(other, range.min, range.max);
    if constexpr (std::is_integral_v<Number>) other = std::round(other);
    values[1 - edited] = Number(other);
    m_last = {double(values[0]), double(values[1])};
  }

 private:
  double m_ratio = 1;  ///< second to first
  std::array<double, 2> m_last{};
};

}  // namespace hogelscope
