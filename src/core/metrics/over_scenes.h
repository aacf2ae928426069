// SPDX-License-Identifier: BSD-3-Clause
// Figures over the scenes of a campaign, each of which weighs alike (docs/formulas.md, Campaigns).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/metrics/summary.h"

namespace hogelscope {

/// The figures of a scene. A test has one name in all scenes, and so has a group.
struct SceneFigures {
  std::string scene;
  std::vector<TestSummary> tests;  ///< without the block of all tests; each has all views
  std::vector<RateGroup> groups;
};

/// The means over scenes of a test's means, in the order of MetricSet::means(); those that are not
/// finite in a scene do not count there.
struct TestOverScenes {
  std::string test;
  std::size_t scenes = 0;  ///< that have the test
  std::vector<double> means;
  std::vector<double> weighted;
  std::vector<Interval> intervals;  ///< 95 %, of the means, then of the weighted ones
};

/// The means over scenes of both deltas of two groups.
struct BdOverScenes {
  std::string anchor;
  std::string group;
  MetricMean quality;
  bool isWeighted = false;
  double rate = unknownFigure;  ///< percent
  double gain = unknownFigure;
  Interval rateInterval{unknownFigure, unknownFigure};  ///< 95 %
  Interval gainInterval{unknownFigure, unknownFigure};
  std::vector<double> ofScenes;  ///< BD-rates, NaN where a scene has none
  std::size_t scenes = 0;        ///< that have one
  std::size_t better = 0;        ///< with a BD-rate below 0
  double signTest = unknownFigure;
  double signedRankTest = unknownFigure;
};

struct OverScenes {
  std::vector<TestOverScenes> tests;
  std::vector<BdOverScenes> comparisons;  ///< in the order of bdRows()
};

/// Tests and groups are in the order in which the scenes name them. Intervals are of 1000 draws of
/// scenes, and of views in each scene that is drawn, the same for all figures.
OverScenes overScenes(const std::vector<SceneFigures>& scenes, const MetricSet& metrics);

}  // namespace hogelscope
