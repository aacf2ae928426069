// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes files of votes: what is read has figures, and ways of the eye are before the panel.
#include "core/metrics/votes.h"
#include "io/documents/votes_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::string text(input);
  mayRefuse([&] {
    const VotesFile file = parseVotes(text);
    require(isVotes(text) && !file.head.viewer.empty());
    Votes votes{.viewers = {"a"}, .states = {"s"}, .contents = {"x", "y"}, .votes = {}};
    for (const VotesTrial& trial : file.trials) {
      require(trial.vote >= 0 && trial.vote <= 5 && trial.shown[0] != trial.shown[1]);
      votes.votes.push_back({0, 0, 0, 1, trial.vote});
    }
    for (const bool arePairs : {false, true}) {
      votes.arePairs = arePairs;
      require(voteRows(votes).empty() == votes.votes.empty());
    }
    for (const Trace::Point& point : traceOf(file).points) require(point.eye.z > 0);
  });
}
