// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <execution>
#include <latch>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hogelscope {

namespace {

/// Distributes pieces of work to threads, until none is left or one has thrown.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : m_count(count) {}

  /// Calls `work(first, last)` for pieces of `length` until none are left.
  template <class Work>
  void run(std::size_t length, const Work& work) noexcept {
    try {
      for (std::size_t k = m_next.fetch_add(length); k < m_count; k = m_next.fetch_add(length))
        work(k, std::min(k + length, m_count));
    } catch (...) {
      m_next = m_count;
      const std::lock_guard lock(m_mutex);
      if (!m_thrown) m_thrown = std::current_exception();
    }
  }
  void rethrow() const {
    if (m_thrown) std::rethrow_exception(m_thrown);
  }

 private:
  std::size_t m_count;
  std::atomic<std::size_t> m_next = 0;
  std::mutex m_mutex;
  std::exception_ptr m_thrown;
};

int coreCount() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::atomic<int> theThreadCount = coreCount();

/// Whether the system allows a thread for each core. TBB ends the process where it does not.
[[maybe_unused]] bool hasThreads() {
  static const bool areStarted = [] {
    std::latch end(1);
    std::vector<std::jthread> threads;
    bool areAllowed = true;
    try {
      for (int k = 1; k < coreCount(); ++k) threads.emplace_back([&end] { end.wait(); });
    } catch (const std::system_error&) {
      areAllowed = false;
    }
    end.count_down();
    return areAllowed;
  }();
  return areStarted;
}

}  // namespace

void serialRows(int count, const std::function<void(int begin, int end)>& rows) {
  rows(0, count);
}

void parallelRows(int count, const std::function<void(int begin, int end)>& rows) {
  constexpr int grain = 4;
  Pieces pieces(std::size_t(std::max(count, 0)));
  std::vector<int> workers(std::size_t(std::clamp(count / grain, 1, threadCount())));
  const auto work = [&] {
    pieces.run(grain, [&](std::size_t begin, std::size_t end) { rows(int(begin), int(end)); });
  };
#ifdef __SANITIZE_THREAD__  // TBB, used by GCC's parallel algorithms, is not built for it
  sideBySide(workers.size(), int(workers.size()), [&](std::size_t, std::size_t) { work(); });
#else
  if (workers.size() > 1 && hasThreads())
    std::for_each(std::execution::par, workers.begin(), workers.end(), [&](int) { work(); });
  else
    work();
#endif
  pieces.rethrow();
}

int threadCount() {
  return theThreadCount;
}

void setThreads(int count) {
  theThreadCount = count > 0 ? std::min(count, coreCount()) : coreCount();
}

void sideBySide(std::size_t count, int workers,
                const std::function<void(std::size_t k, std::size_t worker)>& work) {
  Pieces pieces(count);
  const auto run = [&](std::size_t worker) {
    pieces.run(1, [&](std::size_t k, std::size_t) { work(k, worker); });
  };
  std::vector<std::jthread> threads;
  try {
    for (int worker = 1; worker < workers; ++worker) threads.emplace_back(run, std::size_t(worker));
  } catch (const std::system_error&) {
    // The system allows no more threads, so the started ones do all the work.
  }
  run(0);
  threads.clear();  // joins the threads
  pieces.rethrow();
}

}  // namespace hogelscope
