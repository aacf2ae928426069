// SPDX-License-Identifier: BSD-3-Clause
// Request, listener and result of a report.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/shard.h"
#include "core/metrics/panel_error_figures.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/summary.h"
#include "io/files/system_limits.h"
#include "io/scene/view_source.h"

namespace hogelscope {

/// A test light field: its name in the report, the session with it in place of its own, and its
/// file, which is opened once.
struct ReportTest {
  std::string name;
  Session session;
  std::shared_ptr<LightFieldFile> file;
  std::string order{};  ///< what orderTests() says of the order of its views; "": as it is
  std::optional<ViewSource> unloaded{};  ///< if the twin's maps have been read
};

struct ReportRequest {
  std::string name;                        ///< of the session, for the page's heading
  std::string sessionFile;                 ///< empty if the session was not read from a file
  Session session;                         ///< its states are rendered; its tolerance is ignored
  std::vector<int> frames{};               ///< of each state; empty for a still (takeFrames())
  std::shared_ptr<LightFieldFile> file{};  ///< of the session; makeReport() opens it if null
  std::vector<ReportTest> tests;
  std::vector<RateGroup> groups;
  MetricSet metrics{};
  bool isAgainstIdeal = false;  ///< the reference is the ideal view of a live scene
  /// The tests are twins of the session's display, of which moveMetric() is the last metric.
  bool isAgainstDesign = false;
  std::string output;             ///< the output folder, created if missing
  bool hasRelativeNames = false;  ///< files are named from the output folder, which may move
  std::string command;            ///< the command that requested the report, for its page
  bool images = false;            ///< also write every image
  /// A page with the light fields, page.html of the folder, to which the report's page links.
  bool hasPage = false;
  /// The part of one of several processes: its states' rows and sums stay in the folder for the run
  /// without a shard, which writes the report.
  std::optional<Shard> shard{};
  std::size_t memory = allowedMemory();  ///< bytes for light fields, in addition to the images
  /// The session's light field, if already in memory; not used for one in time.
  std::optional<ViewSource> reference{};
};

/// The order of a report's rows: by state, then by test.
struct ReportOrder {
  std::size_t tests = 0;
  [[nodiscard]] std::size_t row(std::size_t state, std::size_t test) const {
    return state * tests + test;
  }
  [[nodiscard]] std::size_t state(std::size_t row) const { return row / tests; }
  [[nodiscard]] std::size_t test(std::size_t row) const { return row % tests; }
};

/// Callbacks of a run. Each may be empty; all are called from several threads, one at a time.
struct ReportListener {
  Progress progress;
  std::function<void(const ViewSource&)> loaded;
  /// Called when row `index` (ReportOrder) is finished.
  std::function<void(std::size_t index, const ReportRow& row)> finished;
};

struct Report {
  std::vector<ReportRow> rows;
  std::vector<TestSummary> summaries;
  std::vector<BdRow> comparisons;
  std::vector<PanelErrorFigures> panels;  ///< of each test
  std::size_t taken = 0;                  ///< rows taken from an earlier run and from shards
  bool replacedAnother = false;  ///< the folder had the journal of another, unfinished report
  double rendering = 0;          ///< seconds of all threads
  double comparing = 0;          ///< as `rendering`
  double writing = 0;            ///< compressing and writing images, as `rendering`
};

}  // namespace hogelscope
