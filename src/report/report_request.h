// SPDX-License-Identifier: BSD-3-Clause
// What a report is asked for, who follows it, and what it gives.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/shard.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/summary.h"
#include "io/files/system_limits.h"
#include "io/scene/scene.h"

namespace hogelscope {

/// A test light field: its name in the report, it in the place of the session's own, and its file,
/// which is opened once.
struct ReportTest {
  std::string name;
  Session session;
  std::shared_ptr<LightFieldFile> file;
};

struct ReportRequest {
  std::string name;                        ///< of the session, in the page's heading
  std::string sessionFile;                 ///< empty where the session is not what a file holds
  Session session;                         ///< its states are rendered; its tolerance is left aside
  std::shared_ptr<LightFieldFile> file{};  ///< of the session; makeReport() opens it if null
  std::vector<ReportTest> tests;
  std::vector<RateGroup> groups;
  MetricSet metrics{};
  bool isAgainstIdeal = false;  ///< the reference is the ideal view of a live scene
  std::string output;           ///< the folder, made if missing
  std::string command;          ///< how the report was asked for, for its page
  bool images = false;          ///< keep every image, too
  /// One of several processes: its states' rows and sums are left in the folder for the run
  /// without a shard, which writes the report.
  std::optional<Shard> shard{};
  std::size_t memory = allowedMemory();  ///< bytes for light fields, besides the images
  std::optional<Scene> reference{};      ///< the session's light field, if it is in memory already
};

/// The order of a report's rows: of the states, then of the tests.
struct ReportOrder {
  std::size_t tests = 0;
  [[nodiscard]] std::size_t row(std::size_t state, std::size_t test) const {
    return state * tests + test;
  }
  [[nodiscard]] std::size_t state(std::size_t row) const { return row / tests; }
  [[nodiscard]] std::size_t test(std::size_t row) const { return row % tests; }
};

/// Who follows the run. Each may be empty; all are called from several threads, one at a time.
struct ReportListener {
  Progress progress;
  std::function<void(const Scene&)> loaded;
  /// Row `index` (ReportOrder) is finished.
  std::function<void(std::size_t index, const ReportRow& row)> finished;
};

struct Report {
  std::vector<ReportRow> rows;
  std::vector<TestSummary> summaries;
  std::vector<BdRow> comparisons;
  std::size_t taken = 0;         ///< rows of an earlier run, and of shards
  bool replacedAnother = false;  ///< the folder had the journal of another, unfinished report
  double rendering = 0;          ///< seconds of all threads
  double comparing = 0;          ///< the same
  double writing = 0;            ///< the same: compressing images and writing them
};

}  // namespace hogelscope
