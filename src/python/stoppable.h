// SPDX-License-Identifier: BSD-3-Clause
// Work that leaves Python's lock to other threads, tells a listener how far it is, and stops at
// Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/progress.h"

namespace hogelscope {

/// Does the work on a thread of its own, while this one, which has Python's lock, waits without it.
/// Every 20 ms it handles signals and tells `listener` (None, or callable with a fraction 0 … 1)
/// what is new; an exception of either stops the work, which is waited for, and is thrown on.
void runStoppable(const pybind11::object& listener,
                  const std::function<void(const Progress&)>& work);

/// The same for work(progress) that returns something that is no Python object.
template <class Work>
auto stoppable(const pybind11::object& listener, const Work& work) {
  std::optional<decltype(work(Progress()))> result;
  runStoppable(listener, [&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

/// Waits for a lock that other work may hold for long. Throws Cancelled.
std::unique_lock<std::timed_mutex> lockFor(std::timed_mutex& mutex, const Progress& progress);

/// Sets the number of threads of the whole process, 0 for one per core, while it exists. Throws
/// InputError below 0.
class ThreadsOfCall {
 public:
  explicit ThreadsOfCall(int count);
  ~ThreadsOfCall() { setThreads(m_before); }
  ThreadsOfCall(const ThreadsOfCall&) = delete;
  ThreadsOfCall& operator=(const ThreadsOfCall&) = delete;

 private:
  int m_before = threadCount();
};

}  // namespace hogelscope
