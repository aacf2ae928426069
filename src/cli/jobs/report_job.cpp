// SPDX-License-Identifier: BSD-3-Clause
// --report: every state from the session's light field and from each test, compared.
#include "cli/jobs/report_job.h"

#include <cmath>
#include <filesystem>
#include <iostream>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs/report_groups.h"
#include "cli/progress_bar.h"
#include "core/base/text.h"
#include "report/page/summary_page.h"
#include "report/report_run.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// A view that sees nothing does not fail; one that could not be rendered does.
int gate(const std::vector<ReportRow>& rows, const Options& options) {
  if (!options.failBelow) return 0;
  int status = 0;
  for (const ReportRow& row : rows) {
    const double db = psnr(row.metrics.mse);
    if (db >= *options.failBelow || row.problem == seesNothing) continue;
    std::cerr << "hogelscope: " << row.state << ": " << row.test << ": "
              << (row.problem.empty()
                      ? numberText(db) + " dB is below " + numberText(*options.failBelow)
                      : row.problem)
              << "\n";
    status = 1;
  }
  return status;
}

std::vector<RateGroup> groupsOf(const std::vector<ReportTest>& tests, const Options& options) {
  std::vector<TestSize> sizes;
  sizes.reserve(tests.size());
  for (const auto& [name, session, size] : tests)
    sizes.push_back(
        {name, session.lightField.file, double(size.nx) * size.ny * double(size.du) * size.dv});
  return rateGroups(options, sizes);
}

/// "400 views: 62 % of the time rendering, 12 % metrics, 3 % pictures".
std::string timesText(const Report& report) {
  const double all = report.rendering + report.metrics + report.pictures;
  const auto percent = [all](double seconds) {
    return std::to_string(std::lround(100 * seconds / all)) + " %";
  };
  if (!(all > 0)) return {};
  return "time spent                rendering " + percent(report.rendering) + ", metrics " +
         percent(report.metrics) + ", pictures " + percent(report.pictures) + "\n";
}

Report made(const ReportRequest& request, const Options& options) {
  ProgressBar bar("comparing", options.quiet);
  std::size_t finished = 0;
  ReportListener listener;
  listener.progress = bar.progress();
  listener.finished = [&](std::size_t, const ReportRow&) { ++finished; };
  if (options.explain)
    listener.loaded = [&](const Scene& scene) {
      std::cout << explanations(scene, request.session, listener.progress);
    };
  try {
    Report report = makeReport(request, listener);
    bar.done();
    return report;
  } catch (const Cancelled&) {
    bar.done();
    std::cerr << "hogelscope: " << finished << " of "
              << request.session.cameras.size() * request.tests.size()
              << " views are done; the same command goes on from there\n";
    throw;
  }
}

}  // namespace

int reportJob(const Options& options) {
  ReportRequest request;
  request.name = options.session;
  request.sessionFile = options.session;
  request.session = loadSelected(options);
  request.session.sampling.tolerance = 0;  // differences are the light fields', not the methods'
  request.tests = openTests(request.session, options.tests);
  request.groups = groupsOf(request.tests, options);
  request.output = options.output;
  request.command = options.commandLine;
  request.images = options.images;
  const auto announce = [&](const Session& of) {
    announcePassing(*openLightField(of.lightField, of.display), request.memory / 2, options);
  };
  announce(request.session);
  for (const ReportTest& test : request.tests) announce(test.session);
  const Report report = made(request, options);
  if (!options.quiet) {
    const fs::path folder = options.output;
    if (report.replacedAnother)
      std::cerr << "hogelscope: " << (folder / "report.journal").string()
                << ": was of another report that did not finish; begun anew\n";
    if (report.taken > 0)
      std::cerr << "hogelscope: went on after " << report.taken << " views of an earlier run\n";
    std::cout << summaryText(summarise(report.rows), report.rows) << bdText(report.comparisons)
              << timesText(report) << "report in " << (folder / "report.html").string() << " and "
              << (folder / "report.csv").string() << "\n";
  }
  return gate(report.rows, options);
}

}  // namespace hogelscope
