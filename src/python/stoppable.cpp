// SPDX-License-Identifier: BSD-3-Clause
#include "python/stoppable.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

namespace hogelscope {

namespace py = pybind11;

namespace {

constexpr auto pause = std::chrono::milliseconds(20);

/// The messages between the working threads and the one that waits.
class Exchange {
 public:
  void work(const std::function<void(const Progress&, const InPython&)>& function) noexcept {
    try {
      function(
          [this](double done) {
            m_done = std::max(m_done.load(), done);
            return !m_stops;
          },
          [this](std::function<void()> call) { ask(std::move(call)); });
    } catch (...) {
      m_failure = std::current_exception();
    }
    const std::lock_guard lock(m_mutex);
    m_isOver = true;
    m_changed.notify_all();
  }
  /// Waits for the end of the work or for a call that it asks for, up to `pause`. Returns whether
  /// the work is over.
  bool wait() {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, pause, [this] { return m_isOver || m_call; });
    return m_isOver;
  }
  /// Makes the call that the work asks for, if there is one. The work may stop meanwhile.
  void answer() {
    std::unique_lock lock(m_mutex);
    const std::shared_ptr<Call> call = m_call;
    if (!call) return;
    lock.unlock();
    call->make();
    lock.lock();
    call->isMade = true;
    m_call = nullptr;
    m_changed.notify_all();
  }
  void stop() {
    const std::lock_guard lock(m_mutex);
    m_stops = true;
    m_changed.notify_all();
  }
  [[nodiscard]] double done() const { return m_done; }
  [[nodiscard]] bool isOver() {
    const std::lock_guard lock(m_mutex);
    return m_isOver;
  }
  [[nodiscard]] std::exception_ptr failure() const { return m_failure; }

  std::atomic<bool> isInPython = false;  ///< whether the waiting thread is in code of Python

 private:
  struct Call {
    std::function<void()> make;
    bool isMade = false;
  };
  void ask(std::function<void()> make) {
    const auto call = std::make_shared<Call>(std::move(make));
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_stops || !m_call; });
    if (m_stops) throw Cancelled();
    m_call = call;
    m_changed.notify_all();
    m_changed.wait(lock, [&] { return m_stops || call->isMade; });
    if (m_stops) throw Cancelled();
  }

  std::atomic<double> m_done = 0;
  std::atomic<bool> m_stops = false;
  std::exception_ptr m_failure;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::shared_ptr<Call> m_call;  ///< the one that is asked for
  bool m_isOver = false;
};

/// A thread for one call after the other: a new one would have to start the threads of each view
/// anew. It is never destroyed, since Python may end while it waits.
class Worker {
 public:
  /// Throws std::system_error if there is no thread to be had.
  Worker() {
    std::thread([this] { serve(); }).detach();
  }

  void begin(std::function<void()> task) {
    const std::lock_guard lock(m_mutex);
    m_task = std::move(task);
    m_changed.notify_all();
  }
  /// Waits for the task's end.
  void finish() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return !m_task; });
  }

 private:
  [[noreturn]] void serve() {
    std::unique_lock lock(m_mutex);
    while (true) {
      m_changed.wait(lock, [this] { return bool(m_task); });
      lock.unlock();
      m_task();
      lock.lock();
      m_task = nullptr;
      m_changed.notify_all();
    }
  }

  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::function<void()> m_task;
};

/// Calls a Python listener with ascending fractions.
class Listener {
 public:
  explicit Listener(const py::object& callable) : m_callable(callable) {}
  void tell(double done) {
    if (m_callable.is_none() || done <= m_told) return;
    m_told = done;
    callPython(m_callable, py::make_tuple(done));
  }

 private:
  const py::object& m_callable;
  double m_told = -1;
};

/// The end of the interpreter. Python ends while daemon threads run, and ends those that want its
/// lock; with our frames on their stack that would be std::terminate(). It therefore waits until
/// our work has stopped and the threads that started it wait for ever. Those in code of Python,
/// which may sleep for hours, are not waited for: callPython() holds them.
class Ending {
 public:
  /// Called at Python's exit by the ending thread, with the lock.
  void begin() {
    m_ender = std::this_thread::get_id();
    m_isBegun = true;
    const py::gil_scoped_release free;
    while (!isStill()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  /// Returns a worker for the work. Throws std::system_error.
  Worker& enter(Exchange& work) {
    const std::lock_guard lock(m_mutex);
    if (m_idle.empty()) m_idle.push_back(new Worker);  // NOLINT: never destroyed
    Worker* const worker = m_idle.back();
    m_idle.pop_back();
    m_works.push_back(&work);
    return *worker;
  }
  void leave(Exchange& work, Worker& worker) {
    const std::lock_guard lock(m_mutex);
    m_idle.push_back(&worker);
    std::erase(m_works, &work);
  }
  std::mutex& mutex() { return m_mutex; }
  /// Forgets all after a fork, whose copy has no working threads. The mutex must be held.
  void forget() {
    m_works.clear();
    m_idle.clear();
  }
  [[nodiscard]] bool concernsThisThread() const {
    return m_isBegun && m_ender.load() != std::this_thread::get_id();
  }

 private:
  bool isStill() {
    const std::lock_guard lock(m_mutex);
    for (Exchange* const work : m_works) work->stop();
    return std::ranges::all_of(m_works,
                               [](Exchange* work) { return work->isInPython && work->isOver(); });
  }

  std::mutex m_mutex;
  std::vector<Exchange*> m_works;
  std::vector<Worker*> m_idle;
  std::atomic<bool> m_isBegun = false;
  std::atomic<std::thread::id> m_ender{};
};

Ending& ending() {
  static Ending theEnding;
  return theEnding;
}

[[noreturn]] void waitForEver() {
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

/// Waits without Python's lock. Returns whether the work is over.
bool waitFor(Exchange& exchange, Worker& worker) {
  PyThreadState* const state = PyEval_SaveThread();
  bool isOver = exchange.wait();
  if (ending().concernsThisThread()) {
    exchange.stop();
    worker.finish();
    ending().leave(exchange, worker);
    waitForEver();
  }
  if (isOver) worker.finish();
  PyEval_RestoreThread(state);
  return isOver;
}

/// Does what the work wants of Python's code.
void serve(Exchange& exchange, Listener& listener) {
  exchange.isInPython = true;
  exchange.answer();
  listener.tell(exchange.done());
  exchange.isInPython = false;
}

/// Called at another signal whose handler throws, such as Ctrl-C, while the work stops: ends the
/// process as Ctrl-C ends others if the work has not heard of it for as long as in batch mode.
void leaveIfDeaf(std::chrono::steady_clock::time_point stopped) {
  constexpr auto patience = std::chrono::seconds(5);
  if (std::chrono::steady_clock::now() - stopped < patience) return;
  std::signal(SIGINT, SIG_DFL);
  std::raise(SIGINT);
}

}  // namespace

py::object callPython(const py::object& function, const py::tuple& arguments) {
  // Python may end the thread in the call, by unwinding its stack.
  struct Hold {
    bool isBack = false;
    ~Hold() {
      if (!isBack) waitForEver();
    }
  } hold;
  PyObject* const result = PyObject_CallObject(function.ptr(), arguments.ptr());
  hold.isBack = true;
  if (result == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(result);
}

void waitAtExit() {
  ::pthread_atfork([] { ending().mutex().lock(); }, [] { ending().mutex().unlock(); },
                   [] {
                     ending().forget();
                     ending().mutex().unlock();
                   });
  py::module_::import("atexit").attr("register")(py::cpp_function([] { ending().begin(); }));
}

void runStoppable(const py::object& listener,
                  const std::function<void(const Progress&, const InPython&)>& work) {
  Exchange exchange;
  Listener heard(listener);
  std::exception_ptr thrown;  // thrown by Python
  std::chrono::steady_clock::time_point stopped;
  Worker& worker = ending().enter(exchange);
  worker.begin([&] { exchange.work(work); });
  while (!waitFor(exchange, worker)) {
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!thrown) serve(exchange, heard);
    } catch (...) {
      exchange.isInPython = false;
      if (!thrown)
        stopped = std::chrono::steady_clock::now();
      else
        leaveIfDeaf(stopped);
      thrown = std::current_exception();
      exchange.stop();
    }
  }
  ending().leave(exchange, worker);
  if (thrown) std::rethrow_exception(thrown);
  if (exchange.failure()) std::rethrow_exception(exchange.failure());
  heard.tell(1);
}

void runStoppable(const py::object& listener, const std::function<void(const Progress&)>& work) {
  runStoppable(listener, [&](const Progress& progress, const InPython&) { work(progress); });
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
