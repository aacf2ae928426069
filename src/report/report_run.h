// SPDX-License-Identifier: BSD-3-Clause
// The testing procedure (the paper's section V): every camera state rendered from the session's
// light field and from each test light field, and compared; states side by side. Goes on where an
// earlier run of the same request stopped.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/metrics/summary.h"
#include "io/scene/scene.h"
#include "report/page/report_page.h"

namespace hogelscope {

/// A test light field: its name in the report, and it in the place of the session's own.
struct ReportTest {
  std::string name;
  Session session;
  LightFieldSize size;
};

/// Opens every one, so that a bad one is told before the work. Throws InputError.
std::vector<ReportTest> openTests(const Session& session, const std::vector<std::string>& files);

struct ReportRequest {
  std::string name;         ///< of the session, in the page's heading
  std::string sessionFile;  ///< empty where the session is not what a file holds
  Session session;          ///< its states are rendered; its tolerance is left aside
  std::vector<ReportTest> tests;
  std::vector<RateGroup> groups;
  std::string output;                    ///< the folder, made if missing
  std::string command;                   ///< how the report was asked for, for its page
  bool images = false;                   ///< keep every picture, too
  std::size_t memory = allowedMemory();  ///< bytes for light fields, besides the pictures
  std::optional<Scene> reference{};      ///< the session's light field, if it is in memory already
};

/// Who follows the run. Each may be empty; all are called from several threads, one at a time.
struct ReportListener {
  Progress progress;
  std::function<void(const Scene&)> loaded;
  /// Row `index` is finished; rows are in the order of the states, then of the tests.
  std::function<void(std::size_t index, const ReportRow& row)> finished;
};

struct Report {
  std::vector<ReportRow> rows;
  std::vector<TestSummary> summaries;
  std::vector<BdRow> comparisons;
  std::size_t taken = 0;         ///< rows of an earlier run
  bool replacedAnother = false;  ///< the folder had the journal of another, unfinished report
  double rendering = 0;          ///< seconds of all threads
  double metrics = 0;            ///< the same
  double pictures = 0;           ///< the same: compressing and writing
};

/// Writes report.csv, metrics.csv, summary.csv, bd.csv, report.html, panel_error/, and with
/// `images` the pictures. A state that cannot be rendered is a row that says why. Throws
/// InputError, or Cancelled: then what is finished is on disk.
Report makeReport(const ReportRequest& request, const ReportListener& listener);

}  // namespace hogelscope
