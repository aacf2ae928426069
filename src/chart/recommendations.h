// SPDX-License-Identifier: BSD-3-Clause
// Recommendations among the measured methods.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "study/tradeoff.h"

namespace hogelscope {

// Times are only as precise as the runs agree: a method is faster than another if its upper
// quartile lies below the other's fastest run. Otherwise the more accurate one is recommended, then
// the default, whose rays are certified, then the first of the table. The default is also kept if
// another one of its error is at most a quarter faster. Noise therefore does not change the
// recommendation.

/// The time limit of an image that follows the hand smoothly: 60 views per second.
constexpr double movingViewMilliseconds = 1000.0 / 60;

/// Whether the row has times and an error: finite times > 0, a finite error >= 0.
bool isMeasured(const TradeoffRow& row);

/// Returns the most accurate row whose runs stay within movingViewMilliseconds; the fastest of all
/// if there is none; none without measured rows.
std::optional<std::size_t> forMovingView(const std::vector<TradeoffRow>& rows);

/// Returns the fastest row with the least error.
std::optional<std::size_t> forPaper(const std::vector<TradeoffRow>& rows);

enum class Purpose { movingView, standard, paper };
inline constexpr std::array purposes{Purpose::movingView, Purpose::standard, Purpose::paper};

/// Returns the method for a purpose; `standard` is the program's default.
std::optional<std::size_t> recommended(const std::vector<TradeoffRow>& rows, Purpose purpose);

/// Returns the most accurate of the rows that are as fast and as accurate as a measured one, and
/// better in one of them; of equally accurate ones the fastest. None for a row of the Pareto front.
std::optional<std::size_t> betterThan(const std::vector<TradeoffRow>& rows, std::size_t row);

}  // namespace hogelscope
