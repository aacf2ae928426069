// SPDX-License-Identifier: BSD-3-Clause
#include "capture/names/number_gaps.h"

#include <algorithm>

namespace hogelscope {

namespace {

/// Returns the part of a larger grid whose lines begin `pitch` numbers apart; a step of 0 if the
/// numbers are none.
SubGrid subGridOf(const ViewNumbers& numbers, std::int64_t step, std::int64_t pitch) {
  SubGrid grid{step, pitch, (numbers.back() - numbers.front()) / pitch + 1, 1};
  for (const std::int64_t number : numbers) {
    const std::int64_t place = (number - numbers.front()) % pitch;
    if (place % step != 0) return {0, 1, 1, 1};
    grid.count = std::max(grid.count, place / step + 1);
  }
  return grid.count * step < pitch ? grid : SubGrid{0, 1, 1, 1};
}

}  // namespace

bool areTimes(const ViewNumbers& numbers) {
  constexpr std::int64_t thousand = 1000, firstDate = 19900101000000, lastDate = 20991231235959;
  const auto isWithin = [&](std::int64_t least, std::int64_t most) {
    return least <= numbers.front() && numbers.back() <= most;
  };
  std::int64_t unit = 1;
  for (int k = 0; k < 4; ++k, unit *= thousand)
    if (isWithin(1000000000 * unit, 2000000000 * unit)) return true;
  return isWithin(firstDate, lastDate) || isWithin(firstDate * thousand, lastDate * thousand + 999);
}

std::optional<ViewNumbers> begunAgain(const ViewNumbers& numbers) {
  const auto gap = std::ranges::adjacent_find(
      numbers, [&](std::int64_t a, std::int64_t b) { return 2 * (b - a) > numbers.back(); });
  if (gap == numbers.end()) return std::nullopt;
  for (const std::int64_t largest : {999, 9999, 99999}) {
    const std::int64_t round = largest + (numbers.front() == 0 ? 1 : 0);
    const auto span = double(*gap + round - *std::next(gap) + 1);
    if (numbers.back() > largest || 10 * double(numbers.size()) < 9 * span) continue;
    ViewNumbers order(std::next(gap), numbers.end());
    order.insert(order.end(), numbers.begin(), std::next(gap));
    return order;
  }
  return std::nullopt;
}

std::optional<SubGrid> repeatedGaps(const ViewNumbers& numbers) {
  constexpr std::size_t fewest = 4, mostLines = 64;
  const auto count = double(numbers.size());
  if (numbers.size() < fewest) return std::nullopt;
  std::int64_t step = numbers.back();
  for (std::size_t k = 1; k < numbers.size(); ++k)
    step = std::min(step, numbers[k] - numbers[k - 1]);
  if (step < 1) return std::nullopt;
  const double inOneRow = double((numbers.back() - numbers.front()) / step + 1);
  std::optional<SubGrid> best;
  double most = 0.9;
  for (std::size_t k = 1, tried = 0; k < numbers.size() && tried < mostLines; ++k) {
    if (numbers[k] - numbers[k - 1] == step) continue;
    ++tried;
    const SubGrid grid = subGridOf(numbers, step, numbers[k] - numbers.front());
    if (grid.step == 0 || grid.lines < 2 || grid.count < 2) continue;
    const double filled = count / double(grid.lines * grid.count);
    const bool isClear = grid.lines > 2 ? filled == 1 || count < 0.9 * inOneRow
                                        : filled == 1 && count < 0.75 * inOneRow;
    if (!isClear || filled < most || (best && filled <= most)) continue;
    most = filled;
    best = grid;
  }
  return best;
}

}  // namespace hogelscope
