// SPDX-License-Identifier: BSD-3-Clause
// Statistics of viewers' votes: mean opinion scores and the screening of viewers as ITU-R BT.500
// has them, and strengths by Bradley and Terry's model of pairs (docs/formulas.md, Votes).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/metrics/statistics.h"

namespace hogelscope {

/// An answer; the indices are those of the lists in Votes.
struct Vote {
  std::size_t viewer = 0;
  std::size_t state = 0;
  std::size_t first = 0;   ///< the content shown as the first; dsis: the reference
  std::size_t second = 0;  ///< the other content
  int vote = 0;  ///< dsis: 5 imperceptible … 1 very annoying; pairs: 1 or 2 is better, 0 neither
};

struct Votes {
  bool arePairs = false;
  std::vector<std::string> viewers;
  std::vector<std::string> states;
  std::vector<std::string> contents;
  std::vector<Vote> votes;
};

/// The figures of a content in a state, or over all of them. NaN where a method has no such figure.
struct VoteRow {
  std::string state;  ///< "all states" for the last rows
  std::string test;
  std::size_t n = 0;                                ///< votes; over all states of dsis: viewers
  double mos = unknownFigure;                       ///< mean opinion score, 1 … 5
  Interval interval{unknownFigure, unknownFigure};  ///< 95 %, of mos, or of the strength
  double strength = unknownFigure;                  ///< ln of the odds against an average content
};

/// Returns the 97.5 % quantile of Student's t for whole degrees of freedom, at least 1: its
/// distribution in closed form (Abramowitz and Stegun 26.7.3, 26.7.4), by bisection.
double studentQuantile(int degrees);

/// Returns the viewers, in their order, that BT.500 (section A1-2.3.1, for double stimuli) leaves
/// out: more than 5 % of their votes are beyond 2 standard deviations (√20 if the kurtosis is not
/// in 2 … 4) of the mean, above as often as below. None for pairs.
std::vector<std::size_t> screenedViewers(const Votes& votes);

/// Returns the strengths of contents, ln, of mean 0, where `wins` has at a · n + b how
/// often a was better than b; a tie counts half. One tie is added to each pair that was compared,
/// so that a content that always won has a finite strength. NaN for contents that are not connected
/// with the first one, whose strengths have no common scale. By Newton's method.
std::vector<double> bradleyTerry(const std::vector<double>& wins, std::size_t contents);

/// Returns the rows of each state, by contents, then those over all states. Dsis: means of votes,
/// over all states of the viewers' means, with Student's interval. Pairs: strengths, with an
/// interval by the bootstrap over viewers.
std::vector<VoteRow> voteRows(const Votes& votes);

/// Returns `votes.csv`: state, test, n, mos, low, high, bt.
std::string votesCsv(const std::vector<VoteRow>& rows);

}  // namespace hogelscope
