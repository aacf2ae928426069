// SPDX-License-Identifier: BSD-3-Clause
// Recommendations: the most accurate of the rows that are fast enough.
#include "chart/recommendations.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

using Indices = std::vector<std::size_t>;

/// Whether `row` is faster by more than `factor`, beyond the spread of the runs.
bool isFaster(const TradeoffRow& row, const TradeoffRow& other, double factor = 1) {
  return factor * row.upperQuartile < other.fastest;
}

template <typename Condition>
Indices measuredRows(const std::vector<TradeoffRow>& rows, Condition condition) {
  Indices indices;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (isMeasured(rows[k]) && condition(rows[k])) indices.push_back(k);
  return indices;
}

/// Returns the rows that no other one is faster than. The default is excluded only by rows that are
/// faster by more than a quarter.
Indices fastestOf(const std::vector<TradeoffRow>& rows, const Indices& indices) {
  constexpr double hardly = 1.25;
  Indices fastest;
  std::ranges::copy_if(indices, std::back_inserter(fastest), [&](std::size_t k) {
    const double factor = rows[k].isDefault ? hardly : 1;
    return std::ranges::none_of(
        indices, [&](std::size_t other) { return isFaster(rows[other], rows[k], factor); });
  });
  return fastest;
}

Indices mostAccurateOf(const std::vector<TradeoffRow>& rows, const Indices& indices) {
  Indices best;
  for (const std::size_t k : indices) {
    if (!best.empty() && rows[k].rmse < rows[best.front()].rmse) best.clear();
    if (best.empty() || rows[k].rmse == rows[best.front()].rmse) best.push_back(k);
  }
  return best;
}

/// Returns the default if it is among the rows, else the first.
std::optional<std::size_t> pick(const std::vector<TradeoffRow>& rows, const Indices& indices) {
  if (indices.empty()) return std::nullopt;
  const auto found =
      std::ranges::find_if(indices, [&rows](std::size_t k) { return rows[k].isDefault; });
  return found == indices.end() ? indices.front() : *found;
}

}  // namespace

bool isMeasured(const TradeoffRow& row) {
  const auto isTime = [](double time) { return std::isfinite(time) && time > 0; };
  return isTime(row.milliseconds) && isTime(row.fastest) && isTime(row.lowerQuartile) &&
         isTime(row.upperQuartile) && std::isfinite(row.rmse) && row.rmse >= 0;
}

std::optional<std::size_t> forMovingView(const std::vector<TradeoffRow>& rows) {
  const Indices smooth = measuredRows(
      rows, [](const TradeoffRow& row) { return row.fastest <= movingViewMilliseconds; });
  if (!smooth.empty()) return pick(rows, fastestOf(rows, mostAccurateOf(rows, smooth)));
  const Indices all = measuredRows(rows, [](const TradeoffRow&) { return true; });
  return pick(rows, mostAccurateOf(rows, fastestOf(rows, all)));
}

std::optional<std::size_t> forPaper(const std::vector<TradeoffRow>& rows) {
  const Indices all = measuredRows(rows, [](const TradeoffRow&) { return true; });
  return pick(rows, fastestOf(rows, mostAccurateOf(rows, all)));
}

std::optional<std::size_t> recommended(const std::vector<TradeoffRow>& rows, Purpose purpose) {
  if (purpose == Purpose::movingView) return forMovingView(rows);
  if (purpose == Purpose::paper) return forPaper(rows);
  const Indices defaults = measuredRows(rows, [](const TradeoffRow& row) { return row.isDefault; });
  return pick(rows, defaults);
}

std::optional<std::size_t> betterThan(const std::vector<TradeoffRow>& rows, std::size_t row) {
  const Indices better = measuredRows(rows, [&](const TradeoffRow& other) {
    return other.milliseconds <= rows[row].milliseconds && other.rmse <= rows[row].rmse &&
           (other.milliseconds < rows[row].milliseconds || other.rmse < rows[row].rmse);
  });
  const auto figures = [&](std::size_t k) { return std::pair(rows[k].rmse, rows[k].milliseconds); };
  if (better.empty()) return std::nullopt;
  return *std::ranges::min_element(better, {}, figures);
}

}  // namespace hogelscope
