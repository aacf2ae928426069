// SPDX-License-Identifier: BSD-3-Clause
// Work that releases Python's lock, reports progress to a listener, and stops at Ctrl-C. It runs on
// a thread of its own; the calling thread looks every 20 ms for signals and calls the listener,
// since only it may do both. Functions of Python that the work needs are called by it, too: there
// Ctrl-C ends a sleep or a wait for a network.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/progress.h"

namespace hogelscope {

/// Has `call` made by the thread that waits for the work, with Python's lock, and waits for its
/// end. Any working thread may use it. Throws Cancelled if the work stops, at once, so `call` must
/// own what it uses.
using InPython = std::function<void(std::function<void()> call)>;

/// Runs the work on its own thread, while this one, which has Python's lock, waits without it.
/// Every 20 ms it handles signals and reports progress to `listener` (None, or callable with a
/// fraction 0 … 1); it makes the calls that the work asks for. An exception of any of these stops
/// the work, waits for its end, and is rethrown. Work that does not hear of it ends with the
/// process at another Ctrl-C after five seconds.
void runStoppable(const pybind11::object& listener,
                  const std::function<void(const Progress&, const InPython&)>& work);
void runStoppable(const pybind11::object& listener,
                  const std::function<void(const Progress&)>& work);

/// Returns the result of work(progress), which must not be a Python object.
template <class Work>
auto stoppable(const pybind11::object& listener, const Work& work) {
  std::optional<decltype(work(Progress()))> result;
  runStoppable(listener, [&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

/// Calls a function of Python, also in a daemon thread, which Python's end may stop there. Throws
/// pybind11::error_already_set.
pybind11::object callPython(const pybind11::object& function, const pybind11::tuple& arguments);

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
