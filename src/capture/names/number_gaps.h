// SPDX-License-Identifier: BSD-3-Clause
// Says what the gaps between running numbers of views mean. All functions take the numbers
// ascending, each once, at least one, none negative.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace hogelscope {

using ViewNumbers = std::vector<std::int64_t>;

/// Whether the numbers are dates with times, yyyymmddhhmmss with or without milliseconds, or a
/// clock's seconds, or their thousandth, millionth or billionth parts, between 2001 and 2033. The
/// gaps between times say nothing about places.
bool areTimes(const ViewNumbers& numbers);

/// Returns the numbers of a counter of three to five digits that has begun again, in their order:
/// 9998, 9999, 1, 2; none if it has not.
std::optional<ViewNumbers> begunAgain(const ViewNumbers& numbers);

/// A part of a larger grid whose views are counted line by line, such as 0, 4, 8, 36, 40, 44, …:
/// three views of each line, four apart, and the lines 36 apart.
struct SubGrid {
  std::int64_t step = 1;
  std::int64_t pitch = 1;
  std::int64_t lines = 1;
  std::int64_t count = 1;  ///< views of a line
};

/// Returns the part of a larger grid that the gaps between the numbers show, with at most a tenth
/// of its views missing; none if they show none. Two lines have one gap, which repeats nothing, so
/// that gap must be a quarter of the range.
std::optional<SubGrid> repeatedGaps(const ViewNumbers& numbers);

}  // namespace hogelscope
