// SPDX-License-Identifier: BSD-3-Clause
// The votes of one viewer, as a page of `--export page --experiment` saves them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/cameras/camera_set.h"

namespace hogelscope {

/// The document beside its trials.
struct VotesHead {
  std::string page;    ///< a hash of the page: votes of one page belong together
  std::string method;  ///< "pairs", "dsis", or "": the file does not say
  std::string viewer;
};
void describe(ParameterVisitor& v, VotesHead& p);

struct VotesScreen {
  double width = notGiven;     ///< m
  double distance = notGiven;  ///< of the eyes, m
  std::array<int, 2> pixels{1, 1};
};
void describe(ParameterVisitor& v, VotesScreen& p);

/// A question and its answer.
struct VotesTrial {
  std::string state;
  int vote = -1;  ///< dsis: 5 imperceptible … 1 very annoying; pairs: 1 or 2 is better, 0 neither
  double seconds = 0;
  std::array<std::string, 2> shown{};  ///< names of contents
  struct Point {
    double milliseconds = 0;
    int shown = 0;  ///< 0 or 1, index into the names
    Vec3 eye;       ///< in the session's world, m
  };
  std::vector<Point> path{};  ///< at each drawn picture
};
void describe(ParameterVisitor& v, VotesTrial& p);

struct VotesFile {
  VotesHead head;
  VotesScreen screen;
  std::vector<VotesTrial> trials;
};

/// Whether a document says that it holds votes.
bool isVotes(const std::string& text);

/// Reads a document of votes. Throws InputError.
VotesFile parseVotes(const std::string& text);

/// Returns the ways of the eye in all trials, one after the other. Throws InputError if there are
/// none, or if one is not before the panel.
Trace traceOf(const VotesFile& votes);

}  // namespace hogelscope
