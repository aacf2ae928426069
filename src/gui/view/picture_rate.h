// SPDX-License-Identifier: BSD-3-Clause
// How many pictures a second are shown: what a user sees, not what one of them costs.
#pragma once

#include <chrono>
#include <deque>

namespace hogelscope {

class PictureRate {
 public:
  using Clock = std::chrono::steady_clock;

  /// A picture is shown. Returns how many were in the last second, this one too.
  int shown(Clock::time_point now = Clock::now()) {
    m_times.push_back(now);
    while (m_times.front() <= now - std::chrono::seconds(1)) m_times.pop_front();
    return int(m_times.size());
  }

 private:
  std::deque<Clock::time_point> m_times;
};

}  // namespace hogelscope
