// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/rate_curves.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hogelscope {

namespace {

/// Returns the sums for the means: Σ weight · value and Σ weight for each mean.
std::vector<double> meanSums(const ReportRow& row, double weight, const MetricSet& metrics) {
  std::vector<double> sums(2 * metrics.means().size(), 0);
  if (!row.problem.empty()) return sums;
  for (std::size_t k = 0; k < metrics.means().size(); ++k) {
    const double value = row.values[metrics.means()[k].column];
    if (!std::isfinite(value)) continue;
    sums[2 * k] = weight * value;
    sums[2 * k + 1] = weight;
  }
  return sums;
}

}  // namespace

std::vector<double> meansOfSums(const std::vector<double>& sums, const MetricSet& metrics) {
  std::vector<double> means;
  for (std::size_t k = 0; k < sums.size() / 2; ++k) {
    const auto ofMean = metrics.means()[k % metrics.means().size()].ofMean;
    const double mean = sums[2 * k] / sums[2 * k + 1];
    means.push_back(ofMean == nullptr ? mean : ofMean(mean));
  }
  return means;
}

std::vector<double> sumsOf(const ReportRow& row, const MetricSet& metrics) {
  std::vector<double> sums = meanSums(row, 1, metrics);
  std::ranges::copy(meanSums(row, row.weight, metrics), std::back_inserter(sums));
  return sums;
}

RateCurves::RateCurves(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                       const std::vector<RateGroup>& groups)
    : m_metrics(metrics) {
  for (const RateGroup& group : groups) {
    std::vector<Place>& curve = m_curves.emplace_back();
    for (const TestRate& rate : group.tests) {
      const auto found = std::ranges::find(summaries, rate.test, &TestSummary::test);
      if (found == summaries.end()) {
        curve.push_back({rate.rate, std::nullopt});
        continue;
      }
      curve.push_back({rate.rate, m_tests.size()});
      m_tests.push_back(&*found);
    }
  }
}

bool RateCurves::haveWeights() const {
  return std::ranges::any_of(m_tests, &TestSummary::hasWeights);
}

std::vector<std::vector<double>> RateCurves::units() const {
  std::vector<std::vector<double>> units;
  for (std::size_t state = 0; !m_tests.empty() && state < m_tests[0]->rows.size(); ++state) {
    std::vector<double> unit;
    for (const TestSummary* test : m_tests) {
      if (test->rows.size() != m_tests[0]->rows.size()) return {};
      std::ranges::copy(sumsOf(test->rows[state], m_metrics), std::back_inserter(unit));
    }
    units.push_back(std::move(unit));
  }
  return units;
}

std::vector<double> RateCurves::means() const {
  std::vector<double> all;
  for (const TestSummary* test : m_tests)
    for (const bool isWeighted : {false, true})
      std::ranges::copy(test->means(isWeighted).values, std::back_inserter(all));
  return all;
}

BdDelta RateCurves::deltaOf(const BdPair& pair, const std::vector<double>& means) const {
  std::vector<RatePoint> anchor = curveOf(pair.anchor, pair.mean, means);
  std::vector<RatePoint> test = curveOf(pair.group, pair.mean, means);
  const bool isError = m_metrics.means()[pair.mean % m_metrics.means().size()].mayFall &&
                       doesFall(anchor) && doesFall(test);
  if (!isError) return bdDelta(std::move(anchor), std::move(test));
  for (RatePoint& point : anchor) point.quality = -point.quality;
  for (RatePoint& point : test) point.quality = -point.quality;
  BdDelta delta = bdDelta(std::move(anchor), std::move(test));
  delta.quality = -delta.quality;
  delta.from = -std::exchange(delta.to, -delta.from);
  return delta;
}

std::vector<RatePoint> RateCurves::curveOf(std::size_t group, std::size_t mean,
                                           const std::vector<double>& means) const {
  const std::size_t count = 2 * m_metrics.means().size();
  std::vector<RatePoint> points;
  for (const auto& [rate, test] : m_curves[group])
    points.push_back({rate, test ? means[*test * count + mean] : unknownFigure});
  return points;
}

std::vector<BdPair> bdPairs(const MetricSet& metrics, std::size_t groups, bool haveWeights) {
  const std::vector<MetricMean>& means = metrics.means();
  std::vector<BdPair> pairs;
  for (std::size_t anchor = 0; anchor < groups; ++anchor)
    for (std::size_t group = anchor + 1; group < groups; ++group)
      for (const bool isWeighted : {true, false})
        for (const bool isSeen : {true, false})
          for (std::size_t mean = 0; mean < means.size(); ++mean)
            if (means[mean].isQuality && means[mean].isSeen == isSeen &&
                (haveWeights || !isWeighted))
              pairs.push_back({anchor, group, mean + (isWeighted ? means.size() : 0)});
  return pairs;
}

}  // namespace hogelscope
