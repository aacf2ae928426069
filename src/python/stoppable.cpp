// SPDX-License-Identifier: BSD-3-Clause
#include "python/stoppable.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>

namespace hogelscope {

namespace py = pybind11;

namespace {

constexpr auto pause = std::chrono::milliseconds(20);

/// The messages between the working thread and the waiting one.
class Exchange {
 public:
  void work(const std::function<void(const Progress&)>& function) noexcept {
    try {
      function([this](double done) {
        m_done = std::max(m_done.load(), done);
        return !m_stops;
      });
    } catch (...) {
      m_failure = std::current_exception();
    }
    const std::lock_guard lock(m_mutex);
    m_isOver = true;
    m_over.notify_one();
  }
  /// Waits for the end of the work, up to `pause`. Returns whether it is over.
  bool wait() {
    std::unique_lock lock(m_mutex);
    return m_over.wait_for(lock, pause, [this] { return m_isOver; });
  }
  void stop() { m_stops = true; }
  [[nodiscard]] double done() const { return m_done; }
  [[nodiscard]] std::exception_ptr failure() const { return m_failure; }

 private:
  std::atomic<double> m_done = 0;
  std::atomic<bool> m_stops = false;
  std::exception_ptr m_failure;
  std::mutex m_mutex;
  std::condition_variable m_over;
  bool m_isOver = false;
};

/// Calls a Python listener with ascending fractions.
class Listener {
 public:
  explicit Listener(const py::object& callable) : m_callable(callable) {}
  void tell(double done) {
    if (m_callable.is_none() || done <= m_told) return;
    m_told = done;
    m_callable(done);
  }

 private:
  const py::object& m_callable;
  double m_told = -1;
};

/// The end of the interpreter. Python ends while daemon threads run, and ends those that want its
/// lock; with our frames on their stack that would be std::terminate(). It therefore waits for our
/// work, which stops, and the threads that started it never return.
class Ending {
 public:
  /// Called at Python's exit by the ending thread, with the lock.
  void begin() {
    m_ender = std::this_thread::get_id();
    m_isBegun = true;
    const py::gil_scoped_release free;
    while (m_works > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  void enter() { ++m_works; }
  void leave() { --m_works; }
  /// Resets the count after a fork, whose copy has no working threads.
  void forget() { m_works = 0; }
  [[nodiscard]] bool concernsThisThread() const {
    return m_isBegun && m_ender.load() != std::this_thread::get_id();
  }

 private:
  std::atomic<int> m_works = 0;
  std::atomic<bool> m_isBegun = false;
  std::atomic<std::thread::id> m_ender{};
};

Ending& ending() {
  static Ending theEnding;
  return theEnding;
}

/// Waits without Python's lock. Returns whether the work is over.
bool waitFor(Exchange& exchange, std::thread& thread) {
  PyThreadState* const state = PyEval_SaveThread();
  bool isOver = exchange.wait();
  if (ending().concernsThisThread()) {
    exchange.stop();
    thread.join();
    ending().leave();
    while (true) std::this_thread::sleep_for(std::chrono::hours(1));
  }
  if (isOver) thread.join();
  PyEval_RestoreThread(state);
  return isOver;
}

}  // namespace

void waitAtExit() {
  ::pthread_atfork(nullptr, nullptr, [] { ending().forget(); });
  py::module_::import("atexit").attr("register")(py::cpp_function([] { ending().begin(); }));
}

void runStoppable(const py::object& listener, const std::function<void(const Progress&)>& work) {
  Exchange exchange;
  Listener heard(listener);
  std::exception_ptr thrown;  // thrown by Python
  std::thread thread([&] { exchange.work(work); });
  ending().enter();
  while (!waitFor(exchange, thread)) {
    if (thrown) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      heard.tell(exchange.done());
    } catch (...) {
      thrown = std::current_exception();
      exchange.stop();
    }
  }
  ending().leave();
  if (thrown) std::rethrow_exception(thrown);
  if (exchange.failure()) std::rethrow_exception(exchange.failure());
  heard.tell(1);
}

std::unique_lock<std::timed_mutex> lockFor(std::timed_mutex& mutex, const Progress& progress) {
  std::unique_lock lock(mutex, std::defer_lock);
  while (!lock.try_lock_for(pause)) throwIfCancelled(progress);
  return lock;
}

ThreadsOfCall::ThreadsOfCall(int count) : m_isSet(count > 0) {
  if (count < 0)
    throw InputError("threads", std::to_string(count) + " is below 0; 0 is one for each core");
  if (m_isSet) setThreads(count);
}

ThreadsOfCall::~ThreadsOfCall() {
  if (m_isSet) setThreads(0);
}

}  // namespace hogelscope
