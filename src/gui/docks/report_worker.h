// SPDX-License-Identifier: BSD-3-Clause
// Makes a report on a thread of its own.
#pragma once

#include <QObject>
#include <atomic>
#include <thread>

#include "report/report_run.h"

namespace hogelscope {

class ReportWorker : public QObject {
  Q_OBJECT

 public:
  explicit ReportWorker(QObject* parent = nullptr);
  /// Stops what is under way.
  ~ReportWorker() override;

  /// One of the last three signals must have come since the last start. `tests` are files.
  void start(const ReportRequest& request, const std::vector<std::string>& tests);
  /// One of the last three signals comes soon.
  void stop() { m_stops = true; }
  /// How much is done, 0 … 1; to be asked (ViewWorker::readShare).
  [[nodiscard]] double share() const { return m_share; }

 Q_SIGNALS:
  void rowFinished(std::size_t index, const hogelscope::ReportRow& row);
  void finished(const hogelscope::Report& report);
  void stopped();
  void failed(const QString& line);

 private:
  void run(ReportRequest request, const std::vector<std::string>& tests);

  std::atomic<bool> m_stops = false;
  std::atomic<double> m_share = 0;
  std::thread m_thread;
};

}  // namespace hogelscope
