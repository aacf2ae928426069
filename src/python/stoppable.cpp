// SPDX-License-Identifier: BSD-3-Clause
// Work that stops at Ctrl-C.
#include "python/stoppable.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <thread>

namespace hogelscope {

namespace py = pybind11;

namespace {

constexpr auto pause = std::chrono::milliseconds(20);

/// What the working thread and the waiting one tell each other.
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
  /// Whether the work is over, after a pause at the longest.
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

/// Calls a Python listener with fractions that grow.
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

}  // namespace

void runStoppable(const py::object& listener, const std::function<void(const Progress&)>& work) {
  Exchange exchange;
  Listener heard(listener);
  std::exception_ptr thrown;  // by Python
  std::thread thread([&] { exchange.work(work); });
  const auto isOver = [&] {
    const py::gil_scoped_release free;
    return exchange.wait();
  };
  while (!isOver()) {
    if (thrown) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      heard.tell(exchange.done());
    } catch (...) {
      thrown = std::current_exception();
      exchange.stop();
    }
  }
  {
    const py::gil_scoped_release free;
    thread.join();
  }
  if (thrown) std::rethrow_exception(thrown);
  if (exchange.failure()) std::rethrow_exception(exchange.failure());
  heard.tell(1);
}

std::unique_lock<std::timed_mutex> lockFor(std::timed_mutex& mutex, const Progress& progress) {
  std::unique_lock lock(mutex, std::defer_lock);
  while (!lock.try_lock_for(pause)) hearStop(progress);
  return lock;
}

ThreadsOfCall::ThreadsOfCall(int count) {
  if (count < 0)
    throw InputError("threads", std::to_string(count) + " is below 0; 0 is one for each core");
  setThreads(count);
}

}  // namespace hogelscope
