// SPDX-License-Identifier: BSD-3-Clause
// Which of the measured methods to use for what.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/tradeoff_row.h"

namespace hogelscope {

// A time is known as well as its runs agree: one method is faster than another where its upper
// quartile lies below the other's fastest run. Else the more accurate one is advised, then the
// default, whose rays are certified, then the first of the table. The default also stays where
// another one of its error is at most a quarter faster. So noise does not change the advice.

/// A picture that takes no longer moves with the hand: 60 views per second.
constexpr double movingViewMilliseconds = 1000.0 / 60;

/// Has times and an error: finite times > 0, a finite error >= 0.
bool isMeasured(const TradeoffRow& row);

/// The most accurate one whose runs come within movingViewMilliseconds; where there is none, the
/// fastest of all. None without measured rows.
std::optional<std::size_t> forMovingView(const std::vector<TradeoffRow>& rows);

/// The least error, and the fastest with that error.
std::optional<std::size_t> forPaper(const std::vector<TradeoffRow>& rows);

enum class Purpose { movingView, paper, standard };
/// The purposes that a row is the answer to.
std::vector<Purpose> purposesOf(const std::vector<TradeoffRow>& rows, std::size_t row);
const char* words(Purpose purpose);

}  // namespace hogelscope
