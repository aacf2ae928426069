// SPDX-License-Identifier: BSD-3-Clause
// Rate–distortion plots: quality over bits per directional pixel, a curve for each group of tests.
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "page/plot.h"
#include "report/page/report_plots.h"

namespace hogelscope {

namespace {

/// Returns a text such as "a.jpg: 0.25 bits, 31.20 (30.95 … 31.44)".
std::string titleOf(const TestSummary& test, double rate, std::size_t mean, int decimals) {
  const auto number = [&](double value) { return rounded(value, decimals); };
  const Interval& interval = test.intervals[mean];
  return test.test + ": " + numberText(rate) + " bits, " + number(test.summary.means[mean]) + " (" +
         number(interval.low) + " … " + number(interval.high) + ")";
}

/// Returns the finite points of a group, in ascending order of rate.
Plot::Series curveOf(const RateGroup& group, const std::vector<TestSummary>& summaries,
                     std::size_t mean, int decimals) {
  Plot::Series curve{group.name, {}, 4.5};
  for (const TestRate& rate : group.tests)
    for (const TestSummary& test : summaries)
      if (test.test == rate.test && std::isfinite(test.summary.means[mean]))
        curve.points.push_back({std::log10(rate.rate), test.summary.means[mean],
                                titleOf(test, rate.rate, mean, decimals), 0, test.intervals[mean]});
  std::ranges::sort(curve.points, {}, &Plot::Point::across);
  return curve;
}

Plot ratePlot(const std::vector<TestSummary>& summaries, const std::vector<RateGroup>& groups,
              std::size_t index, const MetricMean& mean) {
  Plot plot{"bits per directional pixel",
            mean.title + (mean.unit.empty() ? "" : " in " + mean.unit),
            {1e-3, 1e-3},
            true,
            true,
            {}};
  for (const RateGroup& group : groups)
    plot.series.push_back(curveOf(group, summaries, index, mean.decimals));
  return plot;
}

}  // namespace

std::string ratePlots(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                      const std::vector<RateGroup>& groups) {
  if (groups.empty()) return {};
  std::string plots, legend;
  for (std::size_t k = 0; k < metrics.means().size(); ++k) {
    const MetricMean& mean = metrics.means()[k];
    const bool isOfPlugin = k > meanPsnrYuvSeen;
    if (!mean.isQuality || !(mean.isSeen || isOfPlugin)) continue;
    const Plot plot = ratePlot(summaries, groups, k, mean);
    legend = legendOf(plot);
    if (std::ranges::any_of(plot.series, [](const auto& curve) { return !curve.points.empty(); }))
      plots += svgOf(plot, {376, 296, 46, 12}, "map", plot.titleUp + " over rate");
  }
  return "<figure><div class=\"plots\">\n" + plots + "</div>" + legend + "</figure>\n";
}

}  // namespace hogelscope
