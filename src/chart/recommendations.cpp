// SPDX-License-Identifier: BSD-3-Clause
// Recommendations: the best row by one criterion, ties broken by the other.
#include "chart/recommendations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hogelscope {

namespace {

template <typename Allowed, typename Key>
std::optional<std::size_t> least(const std::vector<TradeoffRow>& rows, Allowed allowed, Key key) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (isMeasured(rows[k]) && allowed(rows[k]) && (!best || key(rows[k]) < key(rows[*best])))
      best = k;
  return best;
}

std::tuple<double, double> byError(const TradeoffRow& row) {
  return {row.rmse, row.milliseconds};
}
std::tuple<double, double> byTime(const TradeoffRow& row) {
  return {row.milliseconds, row.rmse};
}
bool any(const TradeoffRow& /*row*/) {
  return true;
}

/// The default in the place of a row that is no more accurate and hardly faster.
std::optional<std::size_t> orDefault(const std::vector<TradeoffRow>& rows,
                                     std::optional<std::size_t> best, double atMost) {
  constexpr double hardly = 1.25;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (best && rows[k].isDefault && isMeasured(rows[k]) && rows[k].rmse <= rows[*best].rmse &&
        rows[k].milliseconds <= std::min(hardly * rows[*best].milliseconds, atMost))
      best = k;
  return best;
}

}  // namespace

bool isMeasured(const TradeoffRow& row) {
  return std::isfinite(row.milliseconds) && row.milliseconds > 0 && std::isfinite(row.rmse) &&
         row.rmse >= 0;
}

std::optional<std::size_t> forMovingView(const std::vector<TradeoffRow>& rows) {
  const auto isSmooth = [](const TradeoffRow& row) {
    return row.isPareto && row.milliseconds <= movingViewMilliseconds;
  };
  const std::optional<std::size_t> smooth = least(rows, isSmooth, byError);
  return smooth ? orDefault(rows, smooth, movingViewMilliseconds) : least(rows, any, byTime);
}

std::optional<std::size_t> forPaper(const std::vector<TradeoffRow>& rows) {
  return orDefault(rows, least(rows, any, byError), std::numeric_limits<double>::infinity());
}

}  // namespace hogelscope
