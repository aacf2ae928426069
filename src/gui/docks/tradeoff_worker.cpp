// SPDX-License-Identifier: BSD-3-Clause
// Measures speed against accuracy on a thread of its own.
#include "gui/docks/tradeoff_worker.h"

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hogelscope {

TradeoffWorker::TradeoffWorker(QObject* parent) : QObject(parent) {
  qRegisterMetaType<Tradeoff>("hogelscope::Tradeoff");
}

TradeoffWorker::~TradeoffWorker() {
  stop();
  if (m_thread.joinable()) m_thread.join();
}

void TradeoffWorker::start(const std::vector<View>& views) {
  if (m_thread.joinable()) m_thread.join();
  m_stops = false;
  m_share = 0;
  m_thread = std::thread([this, views] { run(views); });
}

void TradeoffWorker::run(const std::vector<View>& views) {
  const Progress progress = [this](double share) {
    m_share = share;
    return !m_stops;
  };
  try {
    Q_EMIT finished(measureTradeoff(views, parallelRows, progress));
  } catch (const Cancelled&) {
    Q_EMIT stopped();
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

}  // namespace hogelscope
