// SPDX-License-Identifier: BSD-3-Clause
// Bisection of an interval.
#pragma once

#include <cmath>

namespace hogelscope {

/// Two places between which a condition changes; either may be the greater one.
struct Bracket {
  double inside;   ///< where it holds
  double outside;  ///< where it does not

  [[nodiscard]] double middle() const { return (inside + outside) / 2; }
};

/// Halves a bracket so many times, or until it is no wider than `tolerance`·|outside|.
template <class IsInside>
Bracket bisect(Bracket ends, int halvings, const IsInside& isInside, double tolerance = 0) {
  for (; halvings > 0; --halvings) {
    if (!(std::abs(ends.outside - ends.inside) > tolerance * std::abs(ends.outside))) break;
    const double middle = ends.middle();
    (isInside(middle) ? ends.inside : ends.outside) = middle;
  }
  return ends;
}

}  // namespace hogelscope
