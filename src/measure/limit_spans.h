// SPDX-License-Identifier: BSD-3-Clause
// Finds where a curve of measured points is within a limit.
#pragma once

#include <array>
#include <vector>

#include "measure/sweep_table.h"

namespace hogelscope {

/// A part of a curve that is within a limit, both ends included.
struct LimitSpan {
  double from = 0;
  double to = 0;
  bool beginsThere = false;  ///< whether the curve crosses the limit at `from`, not begins there
  bool endsThere = false;    ///< whether it crosses the limit at `to`
};

/// Returns the parts from left to right. `points` are (across, up), ascending across, with straight
/// lines between them.
std::vector<LimitSpan> spansWithin(const std::vector<std::array<double, 2>>& points,
                                   const SweepLimit& limit);

}  // namespace hogelscope
