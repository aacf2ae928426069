// SPDX-License-Identifier: BSD-3-Clause
// --report: compares every state's image from the session's light field with that of each test.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "cli/jobs/report_groups.h"
#include "cli/notes.h"
#include "cli/progress_bar.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/plugins/metric_plugins.h"
#include "report/page/summary_page.h"
#include "report/report_run.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns the exit status, from the PSNRs over the seen pixels. A view that sees nothing does not
/// fail; one that could not be rendered, or without a pixel seen in both images, does.
int checkGate(const std::vector<ReportRow>& rows, std::optional<double> least) {
  if (!least) return 0;
  int status = 0;
  for (const ReportRow& row : rows) {
    const double db = row.values[psnrSeenColumn];
    if (db >= *least || row.problem == seesNothing) continue;
    printNote(row.state + ": " + row.test + ": " +
              (!row.problem.empty() ? row.problem
               : std::isnan(db)     ? "no pixel is seen in both pictures"
                                    : "PSNR " + numberText(db) + " dB over what is seen is below " +
                                      numberText(*least)));
    status = 1;
  }
  return status;
}

std::vector<RateGroup> parseGroups(const std::vector<ReportTest>& tests, const CommandLine& line) {
  std::vector<TestSize> sizes;
  sizes.reserve(tests.size());
  for (const auto& [name, session, file] : tests)
    sizes.push_back({name, session.lightField.isLive() ? std::vector<fs::path>() : file->files(),
                     double(file->size().width()) * double(file->size().height())});
  return rateGroups(line, sizes);
}

/// Returns a text such as "400 views: 62 % of the time rendering, 12 % metrics, 3 % images".
std::string timesText(const Report& report) {
  const double all = report.rendering + report.comparing + report.writing;
  const auto percent = [all](double seconds) {
    return std::to_string(std::lround(100 * seconds / all)) + " %";
  };
  if (!(all > 0)) return {};
  return "time spent                rendering " + percent(report.rendering) + ", metrics " +
         percent(report.comparing) + ", pictures " + percent(report.writing) + "\n";
}

Report makeWithProgress(const ReportRequest& request, const CommandLine& line) {
  ProgressBar bar("comparing", line.has("quiet"));
  std::size_t finished = 0;
  ReportListener listener;
  listener.progress = bar.progress();
  listener.finished = [&](std::size_t, const ReportRow&) { ++finished; };
  if (line.has("explain"))
    listener.loaded = [&](const ViewSource& source) {
      std::cout << explanations(source, request.session, listener.progress);
    };
  try {
    Report report = makeReport(request, listener);
    bar.done();
    return report;
  } catch (const Cancelled&) {
    bar.done();
    printNote(std::to_string(finished) + " of " +
              std::to_string(request.session.cameras.size() * request.tests.size()) +
              " views are done; the same command goes on from there");
    throw;
  }
}

}  // namespace

int runReport(const CommandLine& line) {
  const bool isQuiet = line.has("quiet");
  ReportRequest request;
  request.name = line.text("session");
  if (isSessionDocument(request.name)) request.sessionFile = request.name;
  request.session = loadSelected(line);
  request.file = openLightField(request.session.lightField, request.session.display);
  request.isAgainstIdeal = line.has("against");
  if (request.isAgainstIdeal) {
    requireLive(request.session);
    request.tests.push_back({"display", request.session, request.file});
  }
  std::ranges::move(openTests(request.session, line.texts("test")),
                    std::back_inserter(request.tests));
  request.metrics = metricsOf(request.session.metrics);
  request.groups = parseGroups(request.tests, line);
  request.output = line.text("output");
  request.command = line.shellText;
  request.images = line.has("images");
  request.shard = shardOf(line);
  keepSession(line, request.session);
  if (!request.shard) warnOfCuts(*request.file, request.session, line);
  announceStreaming(*request.file, request.memory / 2, isQuiet);
  for (const ReportTest& test : request.tests) {
    warnOf(*test.file, test.name, line);
    announceStreaming(*test.file, request.memory / 2, isQuiet);
  }
  const Report report = makeWithProgress(request, line);
  if (request.shard) {
    if (!isQuiet)
      std::cout << "shard " << textOf(*request.shard) << ": its "
                << request.shard->share(request.session.cameras.size()) * request.tests.size()
                << " views are done; the command without --shard writes the report\n";
    return 0;
  }
  if (!isQuiet) {
    const fs::path folder = line.text("output");
    if (report.replacedAnother)
      printNote((folder / "report.journal").string() +
                ": was of another report that did not finish; begun anew");
    if (report.taken > 0)
      printNote("went on after " + std::to_string(report.taken) + " views of an earlier run");
    std::cout << summaryText(report.summaries.back().summary, report.rows)
              << bdText(report.comparisons) << timesText(report) << "report in "
              << printable((folder / "report.html").string()) << " and "
              << printable((folder / "report.csv").string()) << "\n";
  }
  return checkGate(report.rows, line.number("fail-below"));
}

}  // namespace hogelscope
