// SPDX-License-Identifier: BSD-3-Clause
#include "measure/limit_spans.h"

#include <algorithm>

namespace hogelscope {

std::vector<LimitSpan> spansWithin(const std::vector<std::array<double, 2>>& points,
                                   const SweepLimit& limit) {
  std::vector<LimitSpan> spans;
  bool isWithin = false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& [across, up] = points[k];
    const bool is = limit.allows(up);
    if (k == 0 && is) spans.push_back({across, across, false, false});
    if (k > 0 && is != isWithin) {
      const auto& [before, height] = points[k - 1];
      const double bound = std::min(up, height) < limit.least ? limit.least : limit.most;
      const double place = before + (bound - height) / (up - height) * (across - before);
      if (is) spans.push_back({place, across, true, false});
      if (!is) spans.back().to = place;
      if (!is) spans.back().endsThere = true;
    }
    if (is) spans.back().to = across;
    isWithin = is;
  }
  return spans;
}

}  // namespace hogelscope
