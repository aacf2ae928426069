// SPDX-License-Identifier: BSD-3-Clause
// --status: the progress of the report, or of another long run, in a folder.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

#include "campaign/campaign_journal.h"
#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "runs/journal.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

void addRange(std::string& text, std::size_t first, std::size_t last) {
  if (!text.empty()) text += ", ";
  text += std::to_string(first);
  if (last > first) text += (last > first + 1 ? " to " : ", ") + std::to_string(last);
}

/// Returns a text such as "1 to 3, 7".
std::string rangesText(const std::set<std::size_t>& numbers) {
  std::string text;
  for (auto at = numbers.begin(); at != numbers.end();) {
    const std::size_t first = *at;
    std::size_t last = first;
    while (++at != numbers.end() && *at == last + 1) last = *at;
    addRange(text, first, last);
  }
  return text;
}

/// Returns the numbers 1 … `count` that are not in `numbers`.
std::string gapsText(const std::set<std::size_t>& numbers, std::size_t count) {
  std::string text;
  std::size_t next = 1;
  for (const std::size_t number : numbers) {
    if (number > count) break;
    if (number > next) addRange(text, next, number - 1);
    next = number + 1;
  }
  if (next <= count) addRange(text, next, count);
  return text;
}

/// The journals of one report.
struct Run {
  JournalHead head;
  std::vector<const FoundJournal*> journals;
};

std::vector<Run> runsOf(const std::vector<FoundJournal>& journals) {
  std::vector<Run> runs;
  for (const FoundJournal& journal : journals) {
    auto run = std::ranges::find(runs, journal.head, &Run::head);
    if (run == runs.end()) run = runs.insert(runs.end(), {journal.head, {}});
    run->journals.push_back(&journal);
  }
  return runs;
}

void printShards(const Run& run) {
  std::map<std::size_t, std::map<std::string, std::set<std::size_t>>> byCount;
  for (const FoundJournal* journal : run.journals) {
    if (!journal->shard) continue;
    const bool isDone =
        journal->entries.size() >= journal->shard->share(run.head.states) * run.head.tests;
    byCount[journal->shard->count][isDone             ? "done"
                                   : journal->isInUse ? "at work"
                                                      : "stopped"]
        .insert(journal->shard->number);
  }
  for (const auto& [count, groups] : byCount) {
    std::cout << count << " shards\n";
    std::set<std::size_t> begun;
    const auto say = [](const std::string& group, const std::string& numbers) {
      std::cout << "  " << group << std::string(11 - group.size(), ' ') << numbers << "\n";
    };
    for (const char* group : {"done", "at work", "stopped"})
      if (const auto found = groups.find(group); found != groups.end()) {
        say(group, rangesText(found->second));
        begun.insert(found->second.begin(), found->second.end());
      }
    const std::string missing = gapsText(begun, std::min(count, run.head.states));
    if (!missing.empty()) say("not begun", missing);
  }
}

void print(const Run& run) {
  std::set<std::size_t> rows;
  for (const FoundJournal* journal : run.journals)
    for (const auto& [row, entry] : journal->entries) rows.insert(row);
  const auto isOf = [&run](const char* job) { return run.head.key.starts_with(job); };
  std::cout << rows.size() << " of " << run.head.states * run.head.tests
            << (isOf("measure ") ? " figures are done; the table is not written\n"
                : isOf("sweep ") ? " designs are done; the table is not written\n"
                                 : " views are done; the report is not written\n");
  printShards(run);
  for (const FoundJournal* journal : run.journals)
    if (!journal->shard)
      std::cout << "whole run    " << (journal->isInUse ? "at work" : "stopped") << "\n";
}

/// The folders of a campaign's scenes that are finished or begun, in the order of their names.
int printCampaign(const fs::path& folder) {
  const CampaignJournal finished(folder);
  std::vector<fs::path> scenes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (isFolder(entry.path())) scenes.push_back(entry.path());
  std::ranges::sort(scenes);
  for (const fs::path& scene : scenes) {
    const std::string name = scene.filename().string();
    const std::vector<FoundJournal> journals = findJournals(scene);
    if (finished.scenes().contains(name) || !journals.empty()) std::cout << printable(name) << ": ";
    if (finished.scenes().contains(name)) std::cout << "finished\n";
    if (!finished.scenes().contains(name))
      for (const Run& run : runsOf(journals)) print(run);
  }
  std::cout << "the campaign is not finished\n";
  return 1;
}

int runStatus(const CommandLine& line) {
  const fs::path folder = line.subject;
  if (!isFolder(folder)) throw InputError(line.subject, "is not a folder");
  if (fs::is_regular_file(CampaignJournal::fileIn(folder))) return printCampaign(folder);
  const std::vector<FoundJournal> journals = findJournals(folder);
  if (journals.empty()) {
    for (const char* const table : {"campaign", "report", "measure", "sweep"})
      if (const fs::path file = folder / (std::string(table) + ".csv"); fs::is_regular_file(file)) {
        std::cout << "the " << table << " is finished: " << printable(file.string()) << "\n";
        return 0;
      }
    throw InputError(line.subject, "holds no report, neither finished nor begun");
  }
  for (const Run& run : runsOf(journals)) print(run);
  return 1;
}

}  // namespace

Job statusJob() {
  return {.name = "status",
          .value = "DIR",
          .help =
              "Says how far the report, campaign, measures or sweep in a folder is, and which "
              "shards. Exit "
              "status 0 if it is finished, 1 if not.",
          .examples = "  hogelscope --status report\n",
          .run = runStatus};
}

}  // namespace hogelscope
