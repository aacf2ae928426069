// SPDX-License-Identifier: BSD-3-Clause
// The number of images shown per second, as seen by the user (not the cost of one image).
#pragma once

#include <chrono>
#include <deque>

namespace hogelscope {

class PictureRate {
 public:
  using Clock = std::chrono::steady_clock;

  /// Counts an image. Returns the number in the last second, including this one.
  int shown(Clock::time_point now = Clock::now()) {
    m_times.push_back(now);
    while (m_times.front() <= now - std::chrono::seconds(1)) m_times.pop_front();
    return int(m_times.size());
  }

 private:
  std::deque<Clock::time_point> m_times;
};

}  // namespace hogelscope
