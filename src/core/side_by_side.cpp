// SPDX-License-Identifier: BSD-3-Clause
// Pieces of work on several threads.
#include "core/side_by_side.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hogelscope {

void sideBySide(std::size_t count, int workers,
                const std::function<void(std::size_t k, std::size_t worker)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto run = [&](std::size_t worker) {
    try {
      for (std::size_t k = next++; k < count; k = next++) work(k, worker);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  std::vector<std::jthread> threads;
  try {
    for (int worker = 1; worker < workers; ++worker) threads.emplace_back(run, std::size_t(worker));
  } catch (const std::system_error&) {
    // The machine allows no more threads: those that there are do all the work.
  }
  run(0);
  threads.clear();  // waits
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace hogelscope
