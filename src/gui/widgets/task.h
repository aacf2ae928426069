// SPDX-License-Identifier: BSD-3-Clause
// Runs one long job at a time on its own thread, and queues its answers.
#pragma once

#include <QMetaObject>
#include <QObject>
#include <atomic>
#include <functional>
#include <thread>
#include <utility>

#include "core/base/progress.h"

namespace hogelscope {

/// Orders a call that Qt queues for another thread: what was written before this is copied is read
/// after arrived(). Qt does so too, but not where the thread sanitizer sees it.
class HandOver {
 public:
  HandOver() = default;
  HandOver(const HandOver&) { s_order.fetch_add(1, std::memory_order_release); }
  HandOver& operator=(const HandOver&) = delete;
  ~HandOver() = default;
  void arrived() const { (void)s_order.load(std::memory_order_acquire); }

 private:
  static inline std::atomic<int> s_order = 0;
};

/// Calls `answer` on the object's own thread, from any other thread, unless a newer question has
/// been asked by then. `latest` counts the questions; it is a member of the object that only the
/// object's thread changes.
template <class Answer>
void queueAnswer(QObject* object, const int& latest, int number, Answer answer) {
  QMetaObject::invokeMethod(
      object,
      [&latest, number, answer = std::move(answer), order = HandOver()] {
        order.arrived();
        if (number == latest) answer();
      },
      Qt::QueuedConnection);
}

/// Delivers answers and signals on the thread that the object lives in. Nothing of an older job
/// arrives after start() or abandon().
class Task : public QObject {
  Q_OBJECT

 public:
  using Answer = std::function<void()>;
  /// Runs on the thread and returns the answer that the task calls.
  using Job = std::function<Answer(const Progress&)>;

  using QObject::QObject;
  /// Abandons a running job.
  ~Task() override { join(); }

  /// Starts a job and abandons an older one.
  void start(Job job);
  /// Cancels the job. Its answer or one of the signals follows soon.
  void stop() { m_stops = true; }
  /// Cancels the job and waits for its end.
  void abandon();
  /// Calls `answer` later on the object's thread. The job may call this from any thread.
  void queue(Answer answer);
  /// Whether a job runs; false again when the last answer or signal arrives.
  [[nodiscard]] bool isRunning() const { return m_isRunning; }
  /// Returns the progress, 0 … 1; polled by PolledBar.
  [[nodiscard]] double share() const { return m_share; }

 Q_SIGNALS:
  /// isRunning() has changed. Follows the last answer, or stopped() or failed().
  void runningChanged(bool isRunning);
  void stopped();
  void failed(const QString& line);

 private:
  void join();
  void run(const Job& job);

  int m_number = 0;  ///< the number of the latest job; changes only while no thread runs
  bool m_isRunning = false;
  std::atomic<bool> m_stops = false;
  std::atomic<double> m_share = 0;
  std::thread m_thread;
};

}  // namespace hogelscope
