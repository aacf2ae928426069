// SPDX-License-Identifier: BSD-3-Clause
// Measures speed against accuracy on a thread of its own.
#pragma once

#include <QObject>
#include <atomic>
#include <thread>

#include "study/tradeoff.h"

namespace hogelscope {

class TradeoffWorker : public QObject {
  Q_OBJECT

 public:
  explicit TradeoffWorker(QObject* parent = nullptr);
  /// Stops what is under way.
  ~TradeoffWorker() override;

  /// One of the signals must have come since the last start.
  void start(const std::vector<View>& views);
  /// One of the signals comes soon.
  void stop() { m_stops = true; }
  /// How much is done, 0 … 1; to be asked (ViewWorker::readShare).
  [[nodiscard]] double share() const { return m_share; }

 Q_SIGNALS:
  void finished(const hogelscope::Tradeoff& tradeoff);
  void stopped();
  void failed(const QString& line);

 private:
  void run(const std::vector<View>& views);

  std::atomic<bool> m_stops = false;
  std::atomic<double> m_share = 0;
  std::thread m_thread;
};

}  // namespace hogelscope
