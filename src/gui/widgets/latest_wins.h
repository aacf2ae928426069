// SPDX-License-Identifier: BSD-3-Clause
// A thread for which the newest request wins.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace hogelscope {

/// Serves requests on a thread of its own. Its owner keeps them in members that only ask(), read()
/// and the functions of start() touch: they run under a lock. It is the last member of its owner,
/// so that the thread ends before all that it uses.
class LatestWins {
 public:
  using Lock = std::unique_lock<std::mutex>;

  LatestWins() = default;
  LatestWins(const LatestWins&) = delete;
  LatestWins& operator=(const LatestWins&) = delete;
  ~LatestWins() {
    ask([this] { m_ends = true; });
    if (m_thread.joinable()) m_thread.join();
  }

  /// Calls `serve` with the lock whenever `hasWork`. `serve` takes the requests, unlocks, and does
  /// them.
  template <class HasWork, class Serve>
  void start(HasWork hasWork, Serve serve) {
    m_thread = std::thread([this, hasWork, serve] {
      for (;;) {
        Lock lock(m_mutex);
        m_wake.wait(lock, [&] { return m_ends || hasWork(); });
        if (m_ends) return;
        serve(lock);
      }
    });
  }

  /// Changes the requests, from any thread.
  template <class Change>
  void ask(Change change) {
    {
      const std::lock_guard lock(m_mutex);
      change();
    }
    m_wake.notify_one();
  }

  /// Returns whether the thread has to end, or a newer request wants it: for the work's progress.
  template <class IsWanted>
  bool mustStop(IsWanted isWanted) {
    const std::lock_guard lock(m_mutex);
    return m_ends || isWanted();
  }
  /// Waits for `rest`, or until mustStop() is true, which it returns.
  template <class IsWanted>
  bool mustStopWithin(std::chrono::milliseconds rest, IsWanted isWanted) {
    Lock lock(m_mutex);
    return m_wake.wait_for(lock, rest, [&] { return m_ends || isWanted(); });
  }

 private:
  std::mutex m_mutex;
  std::condition_variable m_wake;
  bool m_ends = false;
  std::thread m_thread;
};

}  // namespace hogelscope
