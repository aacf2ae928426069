// SPDX-License-Identifier: BSD-3-Clause
// Which of the measured methods to use for what.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/tradeoff_row.h"

namespace hogelscope {

// Both prefer the default, whose rays are certified, to what is no more accurate and at most a
// quarter faster: so times that change from run to run do not change the advice.

/// A picture that takes no longer moves with the hand: 60 views per second.
constexpr double movingViewMilliseconds = 1000.0 / 60;

/// Has a time and an error: a finite time > 0, a finite error >= 0.
bool isMeasured(const TradeoffRow& row);

/// The most accurate one of the Pareto front within movingViewMilliseconds; where there is none,
/// the fastest of all. None without measured rows.
std::optional<std::size_t> forMovingView(const std::vector<TradeoffRow>& rows);

/// The least error, and the fastest with that error.
std::optional<std::size_t> forPaper(const std::vector<TradeoffRow>& rows);

}  // namespace hogelscope
