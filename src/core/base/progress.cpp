// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/progress.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>

namespace hogelscope {

namespace {

class SharedProgress {
 public:
  explicit SharedProgress(Progress listener) : m_listener(std::move(listener)) {}

  bool tell(double done) {
    using Clock = std::chrono::steady_clock;
    constexpr Clock::duration pause = std::chrono::milliseconds(20);
    // Stored even if not reported: most calls only poll for cancellation, and a later one may
    // report it.
    double farthest = m_farthest;
    while (done > farthest && !m_farthest.compare_exchange_weak(farthest, done)) continue;
    const auto isTold = [this] { return m_stops || Clock::now() < m_next.load(); };
    if (isTold()) return !m_stops;
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock || isTold()) return !m_stops;  // another thread reports or has just reported
    if (!m_listener(m_farthest)) m_stops = true;
    m_next = Clock::now() + pause;
    return !m_stops;
  }

 private:
  Progress m_listener;
  std::atomic<bool> m_stops = false;
  std::atomic<std::chrono::steady_clock::time_point> m_next{};
  std::atomic<double> m_farthest = 0;
  std::mutex m_mutex;  ///< guards calls of the listener
};

}  // namespace

Progress forThreads(Progress listener) {
  if (!listener) return {};
  const auto shared = std::make_shared<SharedProgress>(std::move(listener));
  return [shared](double done) { return shared->tell(done); };
}

std::string timeLeft(double secondsSoFar, double done) {
  constexpr double least = 2;  // seconds before an estimate is useful
  if (secondsSoFar < least || done <= 0.01 || done >= 1) return {};
  const auto seconds = std::llround(secondsSoFar * (1 - done) / done);
  std::array<char, 40> text{};
  if (seconds >= 3600)
    std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld left", seconds / 3600,
                  seconds / 60 % 60, seconds % 60);
  else
    std::snprintf(text.data(), text.size(), "%lld:%02lld left", seconds / 60, seconds % 60);
  return text.data();
}

bool StepProgress::tell(double within) const {
  return !m_listener || m_listener(m_total > 0 ? (m_done + within) / m_total : 0);
}

void StepProgress::finish(double steps) {
  m_done += steps;
  if (!tell(0)) throw Cancelled();
}

Progress StepProgress::within() {
  return [this](double) { return tell(0); };
}

Progress StepProgress::of(double steps) {
  return [this, steps](double done) { return tell(steps * done); };
}

}  // namespace hogelscope
