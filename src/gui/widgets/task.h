// SPDX-License-Identifier: BSD-3-Clause
// One long job at a time on a thread of its own.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <thread>

#include "core/base/progress.h"

namespace hogelscope {

/// Answers and signals come on the thread that the object lives in, and none of an older job comes
/// after start() or abandon().
class Task : public QObject {
  Q_OBJECT

 public:
  using Answer = std::function<void()>;
  /// Runs on the thread; the task calls what it returns.
  using Job = std::function<Answer(const Progress&)>;

  using QObject::QObject;
  /// Cancels what is under way.
  ~Task() override { abandon(); }

  /// Abandons an older job.
  void start(Job job);
  /// Cancels the job: its answer or one of the signals comes soon.
  void stop() { m_stops = true; }
  /// Cancels the job and waits for its end.
  void abandon();
  /// Calls `answer` later. The job calls this from any thread.
  void queue(Answer answer);
  /// False again when the last answer or signal comes.
  [[nodiscard]] bool isRunning() const { return m_isRunning; }
  /// How much is done, 0 … 1; to be polled (PolledBar).
  [[nodiscard]] double share() const { return m_share; }

 Q_SIGNALS:
  void stopped();
  void failed(const QString& line);

 private:
  void run(const Job& job);

  int m_number = 0;  ///< of the latest job; changes only while no thread runs
  bool m_isRunning = false;
  std::atomic<bool> m_stops = false;
  std::atomic<double> m_share = 0;
  std::thread m_thread;
};

}  // namespace hogelscope
