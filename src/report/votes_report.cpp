// SPDX-License-Identifier: BSD-3-Clause
#include "report/votes_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/votes_file.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns the index of a name in a list, to which it is added if it is new.
std::size_t indexAmong(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return std::size_t(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

double pixelsPerDegree(const VotesScreen& screen) {
  if (screen.width == notGiven || screen.distance == notGiven) return unknownFigure;
  const double degree = screen.distance * std::tan(std::numbers::pi / 180);  // m on the screen
  return screen.pixels[0] / screen.width * degree;
}

/// Says the method of files that do not say it.
std::string guessedMethod(const std::vector<VotesFile>& files) {
  const std::string* reference = nullptr;
  for (const VotesFile& file : files)
    for (const VotesTrial& trial : file.trials) {
      if (reference == nullptr) reference = &trial.shown[0];
      if (trial.vote > 2) return "dsis";
      if (trial.vote == 0 || trial.shown[0] != *reference) return "pairs";
    }
  return "dsis";
}

void checkVote(const VotesTrial& trial, bool arePairs, const std::string& path) {
  const int low = arePairs ? 0 : 1;
  const int high = arePairs ? 2 : 5;
  if (trial.vote < low || trial.vote > high)
    throw InputError(path + ".vote",
                     std::to_string(trial.vote) + " is not " + std::to_string(low) + " to " +
                         std::to_string(high) +
                         (arePairs ? ", an answer on pairs" : ", a grade of BT.500"));
}

/// Adds the answers of a viewer.
void addAnswers(const VotesFile& file, Votes& votes) {
  const std::size_t viewer = indexAmong(votes.viewers, file.head.viewer);
  std::set<std::tuple<std::size_t, std::size_t, std::size_t>> known;
  for (std::size_t k = 0; k < file.trials.size(); ++k) {
    const VotesTrial& trial = file.trials[k];
    const std::string path = "trials[" + std::to_string(k) + "]";
    checkVote(trial, votes.arePairs, path);
    const Vote vote{viewer, indexAmong(votes.states, trial.state),
                    indexAmong(votes.contents, trial.shown[0]),
                    indexAmong(votes.contents, trial.shown[1]), trial.vote};
    const auto [low, high] = std::minmax(vote.first, vote.second);
    if (!known.emplace(vote.state, low, high).second)
      throw InputError(path, "answers a question again: " + trial.shown[0] + ", " + trial.shown[1] +
                                 " in " + trial.state);
    if (!votes.arePairs && vote.first != 0)
      throw InputError(path + ".shown", "has another reference than " + votes.contents[0]);
    votes.votes.push_back(vote);
  }
}

/// Sorts the contents of pairs, whose sides are drawn, by their names.
void sortContents(Votes& votes) {
  const std::vector<std::string> before = votes.contents;
  std::ranges::sort(votes.contents);
  for (Vote& vote : votes.votes)
    for (std::size_t* const content : {&vote.first, &vote.second})
      *content = std::size_t(std::ranges::lower_bound(votes.contents, before[*content]) -
                             votes.contents.begin());
}

/// Names of a page have no folder and no ending.
std::string stemOf(const std::string& name) {
  return fs::path(name).stem().string();
}

/// Whether a table's column is a figure of two pictures.
bool isMetric(const std::string& column) {
  constexpr std::array others{"state", "test", "seen",   "eye_x",  "eye_y",
                              "eye_z", "bits", "weight", "problem"};
  return std::ranges::find(others, column) == others.end();
}

/// Adds the metrics of a table, by rows of the same state and test.
void addCorrelations(const fs::path& file, VotesReport& report) {
  if (!fs::is_regular_file(file)) return;
  const Table table = csvRows(readTextFile(file));
  if (table.empty() || table[0].size() < 2 || table[0][0] != "state" || table[0][1] != "test")
    throw InputError(file.string(), "is no table of a report");
  std::vector<std::pair<std::size_t, std::size_t>> joined;  // lines, rows
  for (std::size_t line = 1; line < table.size(); ++line)
    for (std::size_t row = 0; row < report.rows.size(); ++row)
      if (table[line].size() == table[0].size() && table[line][0] == report.rows[row].state &&
          (table[line][1] == report.rows[row].test ||
           stemOf(table[line][1]) == report.rows[row].test))
        joined.emplace_back(line, row);
  for (std::size_t column = 2; column < table[0].size(); ++column) {
    if (!isMetric(table[0][column])) continue;
    VotesCorrelation one{.metric = table[0][column]};
    std::vector<double> scores;
    for (const auto& [line, row] : joined) {
      const double score = report.votes.arePairs ? report.rows[row].strength : report.rows[row].mos;
      const std::optional<double> value = numberOf(table[line][column]);
      if (!value || !std::isfinite(*value) || !std::isfinite(score)) continue;
      one.rows.push_back(row);
      one.values.push_back(*value);
      scores.push_back(score);
    }
    one.n = scores.size();
    one.plcc = correlation(one.values, scores);
    one.srocc = rankCorrelation(one.values, scores);
    report.correlations.push_back(std::move(one));
  }
}

}  // namespace

VotesReport votesReport(const std::vector<std::string>& files, const fs::path& folder) {
  std::vector<VotesFile> read;
  for (const std::string& file : files)
    read.push_back(inFile(file, [&] { return parseVotes(readTextFile(file)); }));
  VotesReport report;
  std::string method = read.front().head.method;
  if (method.empty()) {
    method = guessedMethod(read);
    report.notes.push_back("The files do not say their method: the votes are taken for " + method +
                           ".");
  }
  Votes& votes = report.votes;
  votes.arePairs = method == "pairs";
  for (std::size_t k = 0; k < read.size(); ++k) {
    const auto& [page, own, viewer] = read[k].head;
    inFile(files[k], [&] {
      if (page != read.front().head.page)
        throw InputError("page", "is of another page than " + files.front() +
                                     ": votes of one page belong together");
      if (own != read.front().head.method)
        throw InputError("method", "is another than that of " + files.front());
      if (std::ranges::find(votes.viewers, viewer) != votes.viewers.end())
        throw InputError("viewer", viewer + " has voted in a file before: give one of them");
      addAnswers(read[k], votes);
    });
    report.viewers.push_back({viewer, read[k].trials.size(), 0, pixelsPerDegree(read[k].screen)});
    for (const VotesTrial& trial : read[k].trials) report.viewers.back().seconds += trial.seconds;
  }
  if (votes.arePairs) sortContents(votes);
  if (votes.votes.empty()) throw InputError(files.front(), "trials", "has no answer");
  for (const std::size_t viewer : screenedViewers(votes)) report.viewers[viewer].isScreened = true;
  report.rows = voteRows(votes);
  addCorrelations(folder / "report.csv", report);
  addCorrelations(folder / "metrics.csv", report);
  const bool isJoined = std::ranges::any_of(report.correlations,
                                            [](const VotesCorrelation& one) { return one.n > 0; });
  if (!report.correlations.empty() && !isJoined) {
    report.notes.emplace_back(
        "The report in the folder has no rows of the votes' states and tests.");
    report.correlations.clear();
  }
  return report;
}

void writeVotes(const VotesReport& report, const fs::path& folder) {
  makeFolder(folder);
  writeTextFile(folder / "votes.csv", votesCsv(report.rows));
  writeTextFile(folder / "votes.html", votesPage(report));
}

}  // namespace hogelscope
