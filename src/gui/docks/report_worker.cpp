// SPDX-License-Identifier: BSD-3-Clause
// Makes a report on a thread of its own.
#include "gui/docks/report_worker.h"

namespace hogelscope {

ReportWorker::ReportWorker(QObject* parent) : QObject(parent) {
  qRegisterMetaType<ReportRow>("hogelscope::ReportRow");
  qRegisterMetaType<Report>("hogelscope::Report");
}

ReportWorker::~ReportWorker() {
  stop();
  if (m_thread.joinable()) m_thread.join();
}

void ReportWorker::start(const ReportRequest& request, const std::vector<std::string>& tests) {
  if (m_thread.joinable()) m_thread.join();
  m_stops = false;
  m_share = 0;
  m_thread = std::thread([this, request, tests] { run(request, tests); });
}

void ReportWorker::run(ReportRequest request, const std::vector<std::string>& tests) {
  ReportListener listener;
  listener.progress = [this](double share) {
    m_share = share;
    return !m_stops;
  };
  listener.finished = [this](std::size_t index, const ReportRow& row) {
    Q_EMIT rowFinished(index, row);
  };
  try {
    request.tests = openTests(request.session, tests);
    Q_EMIT finished(makeReport(request, listener));
  } catch (const Cancelled&) {
    Q_EMIT stopped();
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

}  // namespace hogelscope
