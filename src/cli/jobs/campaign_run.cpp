// SPDX-License-Identifier: BSD-3-Clause
#include "cli/jobs/campaign_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "campaign/campaign.h"
#include "campaign/campaign_journal.h"
#include "campaign/campaign_tables.h"
#include "cli/inputs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/engine/renderer.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "report/report_facts.h"
#include "report/report_run.h"
#include "runs/file_hashes.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Options that a campaign gives to each of its reports.
constexpr std::array<const char*, 6> passed{"set",    "plugins-path", "shard",
                                            "frames", "memory",       "threads"};
constexpr std::array<const char*, 4> passedFlags{"explain", "images", "page", "quiet"};
/// Options that the campaign's document replaces, or that have no meaning for several scenes.
constexpr std::array<const char*, 11> refused{"session", "test",         "group",       "rate",
                                              "against", "twin",         "calibration", "states",
                                              "camera",  "save-session", "fail-below"};

void refuseOptions(const CommandLine& line) {
  for (const char* const option : refused)
    if (line.mayHave(option) && line.has(option))
      throw InputError("command line", "--campaign",
                       "says what each scene compares: leave out --" + std::string(option));
}

/// Returns the command line of a scene's report, with the options that the campaign's has.
CommandLine lineOf(const SceneWork& work, const Campaign& campaign, const CommandLine& line) {
  std::vector<std::string> arguments = work.arguments(campaign);
  for (const char* const option : passed)
    for (const std::string& value : line.texts(option)) {
      arguments.push_back("--" + std::string(option));
      arguments.push_back(value);
    }
  for (const char* const flag : passedFlags)
    if (line.has(flag)) arguments.push_back("--" + std::string(flag));
  return parseCommandLine(arguments);
}

std::string countOf(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

double secondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A folder of its own that is deleted at the end.
class TrialFolder {
 public:
  TrialFolder() : m_path(fs::temp_directory_path() / "hogelscope-XXXXXX") {
    std::string name = m_path.string();
    if (::mkdtemp(name.data()) == nullptr)
      throw InputError(m_path.string(), "cannot be made", "is the disk full?");
    m_path = name;
  }
  ~TrialFolder() {
    std::error_code none;
    fs::remove_all(m_path, none);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return m_path; }

 private:
  fs::path m_path;
};

/// Returns the seconds that a report will take: those of the first view of the first test, with
/// reading and the pictures of the page, for each test; and those of rendering and comparing a view
/// for each of the others.
double secondsFor(const OpenReport& open) {
  ReportRequest trial = open.request;
  const auto tests = double(trial.tests.size());
  const auto views = double(trial.session.cameras.size());
  trial.session.cameras.resize(1);
  trial.tests.resize(1);
  if (!trial.frames.empty()) trial.frames.assign(1, trial.frames.front());
  trial.groups.clear();
  trial.shard.reset();
  const TrialFolder folder;
  trial.output = folder.path().string();
  auto begin = std::chrono::steady_clock::now();
  (void)makeReport(trial, {});
  const double whole = secondsSince(begin);

  const ViewSource source = loadViewSource(trial.session, *trial.file, {});
  Renderer renderer(parallelRows);
  begin = std::chrono::steady_clock::now();
  const Image image = renderer.render(source.job(trial.session.cameras.front()));
  const double rendering = secondsSince(begin);
  begin = std::chrono::steady_clock::now();
  (void)trial.metrics.compare(image, image, parallelRows);
  const double comparing = secondsSince(begin);
  return tests * whole + views * (rendering * (1 + tests) + comparing * tests);
}

std::string timeText(double seconds) {
  constexpr double minute = 60;
  return seconds < minute ? countOf(std::size_t(std::ceil(seconds)), "second")
                          : rounded(seconds / minute, 1) + " minutes";
}

void printDryRun(const Campaign& campaign, const CommandLine& line) {
  std::size_t views = 0;
  double seconds = 0;
  for (const CampaignScene& scene : campaign.scenes) {
    const SceneWork work = workOf(campaign, scene, line.text("output"));
    std::cout << scene.name << ": ";
    if (work.tests.empty()) {
      std::cout << "no test is there\n";
    } else {
      const OpenReport open = openReport(lineOf(work, campaign, line));
      const std::size_t states = open.request.session.cameras.size();
      std::cout << countOf(work.tests.size(), "test") << " of " << countOf(states, "view") << "\n";
      views += states * work.tests.size();
      seconds += secondsFor(open);
    }
    for (const std::string& left : work.lines) std::cout << "  " << printable(left) << "\n";
  }
  std::cout << countOf(views, "comparison") << ", about " << timeText(seconds)
            << " on this machine\n";
}

/// A scene that has tests, and the key of its report.
struct Scene {
  const CampaignScene* scene = nullptr;
  CommandLine line;
  std::string key;
};

/// Opens all scenes, so that what is wrong with one is said before the first is made. Adds their
/// files to `inputs`.
std::vector<Scene> openScenes(const Campaign& campaign, const CommandLine& line,
                              const fs::path& output, std::vector<fs::path>& inputs) {
  std::vector<Scene> scenes;
  FileHashes hashes(output);
  for (const CampaignScene& scene : campaign.scenes) {
    const SceneWork work = workOf(campaign, scene, output);
    for (const std::string& left : work.lines) printNote(scene.name + ": " + left);
    if (work.tests.empty()) continue;
    const OpenReport open = openReport(lineOf(work, campaign, line));
    (void)tableColumns(campaign, open.request.metrics);
    inputs.emplace_back(work.session);
    const std::vector<fs::path> files = inputsOf(open.request);
    inputs.insert(inputs.end(), files.begin(), files.end());
    scenes.push_back({&scene, open.line, factsOf(open.request, hashes, {}).key});
  }
  if (scenes.empty()) throw InputError(campaign.file, "tests", "no scene has any of them");
  return scenes;
}

}  // namespace

int runCampaign(const CommandLine& line) {
  refuseOptions(line);
  const Campaign campaign = loadCampaign(line.text("campaign"));
  if (line.has("dry-run")) {
    printDryRun(campaign, line);
    return 0;
  }
  const bool isQuiet = line.has("quiet");
  const fs::path output = line.text("output");
  std::vector<fs::path> inputs{campaign.file};
  if (!campaign.rateFile.empty()) inputs.emplace_back(campaign.rateFile);
  std::vector<fs::path> results = campaignFiles(output);
  results.push_back(CampaignJournal::fileIn(output));
  {
    const FilesInUse inUse(inputs);
    checkOutputs(results);
  }
  makeFolder(output);
  const std::vector<Scene> scenes = openScenes(campaign, line, output, inputs);
  const FilesInUse inUse(inputs);
  checkOutputs(results);
  CampaignJournal journal(output);
  journal.begin();
  int status = 0;
  for (const Scene& scene : scenes) {
    const std::string& name = scene.scene->name;
    const bool isMade =
        journal.has(name, scene.key) && fs::is_regular_file(output / name / "report.csv");
    if (!isQuiet) std::cout << name << (isMade ? ": taken from the earlier run\n" : ":\n");
    if (isMade) continue;
    OpenReport open = openReport(scene.line);
    status = std::max(status, makeReport(open));
    if (!line.has("shard")) journal.add(name, scene.key);
  }
  if (line.has("shard")) return status;
  const CampaignResult result = writeCampaign(campaign, output);
  journal.remove();
  FileHashes(output).remove();
  if (!isQuiet)
    std::cout << campaignText(result) << "campaign in "
              << printable((output / "campaign.html").string()) << " and "
              << printable((output / "campaign.csv").string()) << "\n";
  return status;
}

}  // namespace hogelscope
