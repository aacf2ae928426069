// SPDX-License-Identifier: BSD-3-Clause
// The page of --votes.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/votes.h"

namespace hogelscope {

/// A viewer, for the page.
struct Viewer {
  std::string name;
  std::size_t answers = 0;
  double seconds = 0;                      ///< of all answers
  double pixelsPerDegree = unknownFigure;  ///< of the screen, in its middle
  bool isScreened = false;                 ///< BT.500 leaves the viewer out
};

/// Says how far a metric goes with the votes, over rows of the same state and test.
struct VotesCorrelation {
  std::string metric;
  std::size_t n = 0;
  double plcc = unknownFigure;      ///< Pearson's, without a fitted curve
  double srocc = unknownFigure;     ///< Spearman's
  std::vector<std::size_t> rows{};  ///< of the votes, and the metric's values
  std::vector<double> values{};
};

struct VotesReport {
  Votes votes;
  std::vector<VoteRow> rows;
  std::vector<Viewer> viewers;
  std::vector<VotesCorrelation> correlations;  ///< empty without a report
  std::vector<std::string> notes;              ///< what is assumed, in sentences
};

/// Returns votes.html: what viewers said of each test, how far metrics go with it, and who voted.
std::string votesPage(const VotesReport& report);

}  // namespace hogelscope
