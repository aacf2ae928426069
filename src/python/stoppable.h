// SPDX-License-Identifier: BSD-3-Clause
// Work that releases Python's lock, reports progress to a listener, and stops at Ctrl-C. It runs on
// a thread of its own; the calling thread looks every 20 ms for signals and calls the listener,
// since only it may do both.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/progress.h"

namespace hogelscope {

/// Runs the work on its own thread, while this one, which has Python's lock, waits without it.
/// Every 20 ms it handles signals and reports progress to `listener` (None, or callable with a
/// fraction 0 … 1). An exception of either stops the work, waits for its end, and is rethrown.
void runStoppable(const pybind11::object& listener,
                  const std::function<void(const Progress&)>& work);

/// Returns the result of work(progress), which must not be a Python object.
template <class Work>
auto stoppable(const pybind11::object& listener, const Work& work) {
  std::optional<decltype(work(Progress()))> result;
  runStoppable(listener, [&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

/// Makes Python's exit wait for the work of daemon threads. Called once, when the module is loaded.
void waitAtExit();

/// Waits for a lock that other work may hold for a long time. Throws Cancelled.
std::unique_lock<std::timed_mutex> lockFor(std::timed_mutex& mutex, const Progress& progress);

/// Sets the number of threads of the whole process during its lifetime; 0 leaves it unchanged.
/// Afterwards it is one per core, regardless of other calls. Throws InputError below 0.
class ThreadsOfCall {
 public:
  explicit ThreadsOfCall(int count);
  ~ThreadsOfCall();
  ThreadsOfCall(const ThreadsOfCall&) = delete;
  ThreadsOfCall& operator=(const ThreadsOfCall&) = delete;

 private:
  bool m_isSet;
};

}  // namespace hogelscope
