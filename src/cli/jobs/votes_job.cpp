// SPDX-License-Identifier: BSD-3-Clause
// --votes: what viewers of an experiment's page said.
#include <cmath>
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/text.h"
#include "report/votes_report.h"

namespace hogelscope {

namespace {

std::string intervalText(const Interval& interval) {
  if (std::isnan(interval.low)) return {};
  return " (" + numberText(fourDigits(interval.low)) + " to " +
         numberText(fourDigits(interval.high)) + ")";
}

int runVotes(const CommandLine& line) {
  const std::filesystem::path folder = line.text("output");
  const FilesInUse inUse({folder / "report.csv", folder / "metrics.csv"});
  checkOutputs({folder / "votes.csv", folder / "votes.html"});
  const VotesReport report = votesReport(line.subjects, folder);
  writeVotes(report, folder);
  if (line.has("quiet")) return 0;
  for (const std::string& note : report.notes) printNote(note);
  for (const Viewer& viewer : report.viewers)
    if (viewer.isScreened)
      printNote(printable(viewer.name) +
                " is left out: votes far from the others', as BT.500 says");
  for (const VoteRow& row : report.rows)
    if (row.state == report.rows.back().state)
      std::cout << "  " << printable(row.test) << ": "
                << numberText(fourDigits(report.votes.arePairs ? row.strength : row.mos))
                << intervalText(row.interval) << "\n";
  std::cout << report.votes.votes.size() << " answers of " << report.viewers.size()
            << " viewer(s) in " << printable((folder / "votes.csv").string()) << " and "
            << printable((folder / "votes.html").string()) << "\n";
  return 0;
}

}  // namespace

Job votesJob() {
  return {
      .name = "votes",
      .value = "FILE",
      .mayRepeat = true,
      .help =
          "Reads the votes of viewers, files that a page of --export page --experiment saves: "
          "DIR/votes.csv, votes.html with means and intervals.",
      .details =
          "For grades (dsis) mean opinion scores, and viewers are screened as ITU-R BT.500 "
          "says; for pairs strengths by Bradley and Terry. If DIR has a finished report, its "
          "metrics stand beside the votes of the same states and tests, with their correlation. "
          "The files are traces, too: --make-cameras FILE makes states of where viewers looked.",
      .examples =
          "  hogelscope --votes votes_1.json --votes votes_2.json --output report\n"
          "  hogelscope --votes votes/*.json --output report\n",
      .needs = {"output"},
      .takes = {"quiet"},
      .run = runVotes};
}

}  // namespace hogelscope
