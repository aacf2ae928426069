// SPDX-License-Identifier: BSD-3-Clause
// --report: compares every state's image from the session's light field with that of each test.
// --rate and --group: the tests of each rate-distortion curve, and their rates.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <set>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/jobs/campaign_run.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/parameters.h"
#include "core/base/text.h"
#include "core/metrics/flicker.h"
#include "core/optics/eyes.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/plugins/metric_plugins.h"
#include "report/page/report_tables.h"
#include "report/report_facts.h"
#include "report/report_files.h"
#include "report/report_frames.h"
#include "report/report_moves.h"
#include "report/report_run.h"
#include "report/test_orders.h"
#include "web/view_page.h"

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
    printNote(viewName(row) + ": " + row.test + ": " +
              (!row.problem.empty() ? row.problem
               : std::isnan(db)     ? "no pixel is seen in both pictures"
                                    : "PSNR " + numberText(db) + " dB over what is seen is below " +
                                      numberText(*least)));
    status = 1;
  }
  return status;
}

void refuseUnknown(const std::string& test, const std::string& flag,
                   const std::vector<ReportTest>& tests) {
  std::vector<std::string_view> names;
  for (const ReportTest& one : tests) {
    if (one.name == test) return;
    names.push_back(one.name);
  }
  const std::string_view nearest = nearestName(test, names);
  throw InputError(
      "command line", flag,
      "\"" + test + "\" is not given as --test" +
          (nearest.empty() ? std::string() : "; did you mean " + std::string(nearest) + "?"));
}

/// Parses FILE=bpp; FILE may contain "=".
std::vector<TestRate> parseRates(const std::vector<std::string>& texts,
                                 const std::vector<ReportTest>& tests) {
  std::vector<TestRate> rates;
  for (const std::string& text : texts) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos)
      throw InputError("command line", "--rate",
                       "\"" + text + "\" is not FILE=BITS, such as test.jpg=0.5");
    const TestRate rate{text.substr(0, equals), 0};
    const std::string number = text.substr(equals + 1);
    const std::optional<double> value = numberOf(number);
    if (!value || !(*value > 0) || !std::isfinite(*value))
      throw InputError("command line", "--rate",
                       "\"" + number + "\" is not a number of bits above 0");
    refuseUnknown(rate.test, "--rate", tests);
    if (std::ranges::find(rates, rate.test, &TestRate::test) != rates.end())
      throw InputError("command line", "--rate", "gives " + rate.test + " two rates");
    rates.push_back({rate.test, *value});
  }
  return rates;
}

double findRate(const std::string& test, const std::vector<TestRate>& rates,
                const std::vector<ReportTest>& tests) {
  const auto rate = std::ranges::find(rates, test, &TestRate::test);
  if (rate != rates.end()) return rate->rate;
  const std::optional<double> own = rateOfFiles(*std::ranges::find(tests, test, &ReportTest::name));
  if (!own)
    throw InputError("command line", "--group",
                     test + " has no size of its own; give --rate " + test + "=BITS");
  return *own;
}

/// Parses NAME=FILE,FILE,…; the rates are not known yet.
RateGroup parseGroup(const std::string& text, const std::vector<ReportTest>& tests) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("command line", "--group", "\"" + text + "\" is not NAME=FILE,FILE,FILE,FILE");
  RateGroup group{text.substr(0, equals), {}};
  for (std::size_t from = equals + 1; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string test = text.substr(from, to - from);
    refuseUnknown(test, "--group " + group.name, tests);
    if (std::ranges::find(group.tests, test, &TestRate::test) != group.tests.end())
      throw InputError("command line", "--group " + group.name, "has " + test + " twice");
    group.tests.push_back({test, 0});
    from = to + 1;
  }
  if (group.tests.size() < 4)
    throw InputError("command line", "--group " + group.name,
                     "has " + std::to_string(group.tests.size()) +
                         " light field(s), but a rate-distortion curve needs four or more");
  return group;
}

/// Returns each --group with its tests' rates: those of --rate, else from the file sizes; none
/// without --group. Throws InputError for a test that was not given, fewer than four tests, or a
/// rate that is not a positive number.
std::vector<RateGroup> rateGroups(const CommandLine& line, const std::vector<ReportTest>& tests) {
  if (!line.has("group") && line.has("rate"))
    throw InputError("command line", "--rate",
                     "is for --group NAME=FILE,FILE,…, of which there is none");
  const std::vector<TestRate> rates = parseRates(line.texts("rate"), tests);
  std::vector<RateGroup> groups;
  for (const std::string& text : line.texts("group")) {
    groups.push_back(parseGroup(text, tests));
    for (TestRate& test : groups.back().tests) test.rate = findRate(test.test, rates, tests);
    for (std::size_t k = 0; k + 1 < groups.size(); ++k)
      if (groups[k].name == groups.back().name)
        throw InputError("command line", "--group " + groups[k].name, "is given twice");
  }
  return groups;
}

/// Returns the units of --twin: their files' names are the tests' names.
std::vector<std::pair<std::string, Session>> unitsOf(const CommandLine& line,
                                                     const Session& session) {
  std::vector<std::pair<std::string, Session>> units;
  std::set<std::string> names;
  for (const std::string& file : line.texts("twin")) {
    if (!names.insert(fs::path(file).stem().string()).second)
      throw InputError("command line", "--twin " + file,
                       "has the name of another twin: name their files differently");
    units.emplace_back(fs::path(file).filename().string(), withTwin(session, file, line));
  }
  return units;
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

/// Writes the page in which one looks around in the light fields that are compared.
void writePage(const ReportRequest& request, const CommandLine& line) {
  ProgressBar bar("making the page", line.has("quiet"));
  std::vector<PageContent> contents{{request.name, request.file}};
  for (const ReportTest& test : request.tests) contents.push_back({test.name, test.file});
  for (PageContent& content : contents) content.name = fs::path(content.name).stem().string();
  const ViewPage page =
      viewPage(request.session, contents, {contents.front().name}, bar.progress());
  makeFolder(request.output);
  writeTextFile(fs::path(request.output) / "page.html", page.html);
  bar.done();
}

/// Throws if a page cannot show what is compared.
void requirePageOf(const ReportRequest& request) {
  if (request.isAgainstIdeal || request.isAgainstDesign)
    throw InputError("command line", "--page", "compares light fields: it is not for --against");
  requirePage(request.session);
  for (const ReportTest& test : request.tests) requirePage(test.session);
}

/// Returns what the command line asks for; the light fields are open.
ReportRequest requestOf(const CommandLine& line, const Session& session) {
  ReportRequest request;
  request.name = line.text("session");
  if (isSessionDocument(request.name)) request.sessionFile = request.name;
  request.session = withEyes(session);
  request.file = openLightField(request.session.lightField, request.session.display);
  request.isAgainstIdeal = line.text("against", "") == "ideal";
  if (request.isAgainstIdeal) {
    requireLive(request.session);
    request.tests.push_back({"display", request.session, request.file});
  } else if (line.has("against") && !compareWithDesign(request, unitsOf(line, request.session))) {
    throw InputError("command line", "--against design",
                     "needs a unit to compare: --twin FILE, or a session with a twin");
  }
  std::ranges::move(openTests(request.session, line.texts("test")),
                    std::back_inserter(request.tests));
  takeFrames(request, framesOf(line, *request.file));
  std::vector<Metric> others;
  if (!request.frames.empty()) others.push_back(flickerMetric());
  if (request.isAgainstDesign) others.push_back(moveMetric());  // the last one
  request.metrics = metricsOf(request.session.metrics, std::move(others));
  request.groups = rateGroups(line, request.tests);
  request.output = line.text("output");
  request.command = line.shellText;
  request.images = line.has("images");
  request.hasPage = line.has("page");
  if (request.hasPage) requirePageOf(request);
  request.shard = shardOf(line);
  return request;
}

/// Prints what makes the figures doubtful, and what takes long.
void warnOfInputs(ReportRequest& request, const Session& session, const CommandLine& line) {
  const bool isQuiet = line.has("quiet");
  if (!request.shard) {
    warnOfCuts(*request.file, request.session, line);
    warnOfPupils(resolved(displayOf(session), request.file->size()), session, line);
    for (const ReportTest& test : request.tests)
      (void)resolved(displayOf(test.session), test.file->size());
  }
  if (!request.shard && !isQuiet) {
    for (ReportTest& test : request.tests) {
      if (test.session.twin.maps == TwinMapFiles{}) continue;
      ViewSource unloaded = unloadedOf(test.session, *test.file, line);
      // Later ones are read again, so that the maps of one test are in memory at a time.
      if (&test == &request.tests.front()) test.unloaded = std::move(unloaded);
    }
    for (const std::string& warning : warningsOf(request)) printNote(warning);
  }
  announceStreaming(*request.file, request.memory / 2, isQuiet);
  for (const ReportTest& test : request.tests) {
    warnOf(*test.file, test.name, line);
    announceStreaming(*test.file, request.memory / 2, isQuiet);
  }
}

void printResults(const Report& report, const ReportRequest& request) {
  const fs::path folder = request.output;
  printFound(folder, report.replacedAnother, report.taken, "views", "report");
  std::cout << (request.tests.size() == 1
                    ? summaryText(report.summaries.front().summary, report.rows)
                    : testsText(report.summaries))
            << bdText(report.comparisons, request.metrics);
  for (const std::string& note : harmlessMoves(report.summaries, request.metrics))
    std::cout << note << "\n";
  std::cout << timesText(report) << "report in " << printable((folder / "report.html").string())
            << " and " << printable((folder / "report.csv").string()) << "\n";
}

int runReport(const CommandLine& line) {
  if (line.has("campaign")) return runCampaign(line);
  if (line.has("dry-run"))
    throw InputError("command line", "--dry-run", "is for --campaign, which is missing");
  OpenReport open = openReport(line);
  return makeReport(open);
}

}  // namespace

OpenReport openReport(const CommandLine& line) {
  OpenReport open{line, loadSelected(line), {}};
  open.request = requestOf(line, open.session);
  return open;
}

int makeReport(OpenReport& open) {
  auto& [line, session, request] = open;
  const bool isQuiet = line.has("quiet");
  const FilesInUse inUse(inputsOf(request));
  checkResults(line, session, filesOf(request));
  orderTests(request, {});
  warnOfInputs(request, session, line);
  if (request.hasPage && !request.shard) writePage(request, line);
  const Report report = makeWithProgress(request, line);
  finish(line, session);
  if (request.shard) {
    const std::size_t views = ShardOfViews(request).count() * request.tests.size();
    if (!isQuiet) printShard(request.shard, std::to_string(views) + " views", "report");
    return 0;
  }
  if (!isQuiet) printResults(report, request);
  return checkGate(report.rows, line.number("fail-below"));
}

Job reportJob() {
  return {
      .name = "report",
      .help =
          "Renders every state from the session's light field and from each test light field, "
          "and compares them: DIR/report.csv, metrics.csv, summary.csv, report.html.",
      .details =
          "After a stop the same command goes on where it was. Many processes, on one "
          "machine or on many that share the folder, make one report: --shard K/N does a "
          "part of the views; then the command without --shard takes up the parts, does "
          "what is missing, and writes the report.",
      .examples =
          "  hogelscope --report --session s.json --test coded.png --output report\n"
          "  hogelscope --report --session s.json --test coded.png --output report --shard 2/4\n"
          "  hogelscope --report --session s.json --test coded.png --output report --images \\\n"
          "             --fail-below 30\n"
          "  hogelscope --report --session s.json --test a1.jpg … --test b4.jp2 --output report "
          "\\\n"
          "             --group JPEG=a1.jpg,a2.jpg,a3.jpg,a4.jpg \\\n"
          "             --group JPEG2000=b1.jp2,b2.jp2,b3.jp2,b4.jp2\n"
          "  hogelscope --report --campaign scenes.json --output campaign\n",
      .needs = {"session", "output", "test"},
      .takes = {"set", "states", "calibration", "twin", "plugins-path", "save-session", "shard",
                "frames", "explain", "memory", "threads", "quiet"},
      .own =
          {{.name = "images",
            .after = "masks",
            .help = "Also the pictures, DIR/reference and DIR/test1, test2, …"},
           {.name = "page",
            .after = "images",
            .help = "Also DIR/page.html, in which anyone looks around in the light fields, one at "
                    "a time, side by side or as their error (as --export page --test)."},
           {.name = "test",
            .value = "LF",
            .heading = "Comparing light fields",
            .after = "explain",
            .unless = {"against", "campaign"},
            .isInput = true,
            .mayRepeat = true,
            .help =
                "A light field to compare with the session's: an image, a folder, a store, or a "
                "session, whose display comes with it. Repeat it for more."},
           {.name = "against",
            .value = "ideal|design",
            .choices = {"ideal", "design"},
            .help =
                "ideal: the reference is the ideal view of the session's live scene, what the eye "
                "would see of it without the display; the display is then the first test. design: "
                "the reference is the display as designed, and each --twin is a test."},
           {.name = "campaign",
            .value = "FILE",
            .heading = "Several scenes",
            .after = "fail-below",
            .isInput = true,
            .help = "A document of scenes, each with a session, and of tests that all of them "
                    "have, in place of --session, --test, --group and --rate: a report for each "
                    "scene in DIR/SCENE, and campaign.csv, summary.csv, bd.csv and campaign.html "
                    "over the scenes."},
           {.name = "dry-run",
            .after = "campaign",
            .help = "Only says which tests of a --campaign are there or missing, how many views "
                    "there are, and how long they take."},
           {.name = "fail-below",
            .value = "DB",
            .range = NumberRange{},
            .help = "Exit status 1 if any PSNR over the pixels seen is below."},
           {.name = "group",
            .value = "NAME=LF,LF,…",
            .mayRepeat = true,
            .help =
                "Tests that make one rate-distortion curve, four or more. Every pair of groups is "
                "compared: BD-rates and BD-qualities in DIR/bd.csv."},
           {.name = "rate",
            .value = "LF=BITS",
            .mayRepeat = true,
            .help = "Of a --group's test: bits per directional pixel, if not those of its file's "
                    "size."}},
      .run = runReport};
}

}  // namespace hogelscope
