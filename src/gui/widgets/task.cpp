// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/task.h"

#include <utility>

#include "core/base/error.h"

namespace hogelscope {

void Task::start(Job job) {
  join();
  m_stops = false;
  m_share = 0;
  m_isRunning = true;
  m_thread = std::thread([this, job = std::move(job)] { run(job); });
  Q_EMIT runningChanged(true);
}

void Task::abandon() {
  join();
  if (std::exchange(m_isRunning, false)) Q_EMIT runningChanged(false);
}

void Task::join() {
  stop();
  if (m_thread.joinable()) m_thread.join();
  ++m_number;
}

void Task::queue(Answer answer) {
  queueAnswer(this, m_number, m_number, std::move(answer));
}

/// Runs the job; called on the thread.
void Task::run(const Job& job) {
  const auto finish = [this](const Answer& answer) {
    queue([this, answer] {
      m_isRunning = false;
      answer();
      if (!m_isRunning) Q_EMIT runningChanged(false);  // the answer may start another job
    });
  };
  try {
    const Answer answer = job([this](double share) {
      m_share = share;
      return !m_stops;
    });
    m_share = 1;
    finish(answer);
  } catch (const Cancelled&) {
    finish([this] { Q_EMIT stopped(); });
  } catch (const std::exception& error) {
    finish([this, line = QString::fromUtf8(error.what())] { Q_EMIT failed(line); });
  }
}

}  // namespace hogelscope
