// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/summary.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "core/base/text.h"
#include "core/metrics/rate_curves.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

namespace {

/// Returns the name of a mean's region in files.
const char* regionOf(bool isSeen) {
  return isSeen ? "seen" : "frame";
}

void addTo(std::vector<double>& sums, const std::vector<double>& more) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += more[k];
}

/// Returns a bootstrap unit for each state, and frame, because a viewer's observations are drawn as
/// a whole.
std::vector<std::vector<double>> unitsOf(const std::vector<ReportRow>& rows,
                                         const MetricSet& metrics) {
  std::vector<std::vector<double>> units;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool isSameView = k > 0 && rows[k].state == rows[k - 1].state &&
                            rows[k].frame == rows[k - 1].frame;  // adjacent in a report
    if (isSameView)
      addTo(units.back(), sumsOf(rows[k], metrics));
    else
      units.push_back(sumsOf(rows[k], metrics));
  }
  return units;
}

TestSummary summaryOf(const std::string& test, std::vector<ReportRow> rows,
                      const MetricSet& metrics) {
  TestSummary result{test, std::move(rows), {}, {}, {}};
  result.summary = summariseRows(result.rows, metrics);
  const std::vector<std::vector<double>> units = unitsOf(result.rows, metrics);
  const auto means = [&](const std::vector<double>& sums) { return meansOfSums(sums, metrics); };
  result.intervals = bootstrap(units, means, {.resamples = resamplesFor(units.size())});
  return result;
}

/// Adds the rows of a test to the table of summary.csv.
void addRows(Table& table, const TestSummary& summary, const MetricSet& metrics) {
  const auto add = [&](const std::string& figure, const std::vector<double>& values,
                       const std::string& region = {}, const std::string& state = {}) {
    table.push_back({summary.test, figure, "", "", "", "", "", "", state, region});
    std::ranges::transform(values, table.back().begin() + 2, numberText);
  };
  const auto addWorst = [&](const char* figure, std::optional<std::size_t> row, MetricIndex column,
                            bool isSeen) {
    if (row)
      add(figure, {summary.rows[*row].values[column]}, regionOf(isSeen),
          viewName(summary.rows[*row]));
  };
  add("views", {double(summary.rows.size())});
  add("identical_views", {double(summary.summary.identical)});
  add("views_without_comparison", {double(summary.summary.withoutView)});
  const MeansOfTest plain = summary.means(false);
  const MeansOfTest weighted = summary.means(true);
  for (std::size_t k = 0; k < plain.values.size(); ++k) {
    const Interval& interval = plain.intervals[k];
    const Interval& other = weighted.intervals[k];
    add(metrics.means()[k].name,
        {plain.values[k], interval.low, interval.high, weighted.values[k], other.low, other.high},
        regionOf(metrics.means()[k].isSeen));
  }
  addWorst("worst_psnr", summary.summary.worstFrame, psnrColumn, false);
  addWorst("worst_psnr_seen", summary.summary.worst, psnrSeenColumn, true);
  if (summary.rate) add("rate_bpp", {*summary.rate});
  if (summary.kilobits) add("rate_kbps", {*summary.kilobits});
}

/// Returns what stands behind "mean_" in a mean's name; "" for other means.
std::string figureOf(const MetricMean& mean) {
  constexpr std::string_view start = "mean_";
  return mean.ofMean == nullptr && mean.name.starts_with(start) ? mean.name.substr(start.size())
                                                                : std::string();
}

/// Adds to summary.csv what the frames of a light field in time have: of each figure the worst and
/// the 5th percentile; of one state, if it is given, its means too.
void addFrames(Table& table, const std::string& test, const std::vector<ReportRow>& rows,
               const std::string& state, const MetricSet& metrics) {
  const auto add = [&](const std::string& figure, double value, bool isSeen) {
    table.push_back({test, figure, numberText(value), "", "", "", "", "", state, regionOf(isSeen)});
  };
  const ReportSummary summary = summariseRows(rows, metrics);
  for (std::size_t k = 0; k < metrics.means().size(); ++k) {
    const MetricMean& mean = metrics.means()[k];
    if (!state.empty()) add(mean.name, summary.means[k], mean.isSeen);
    const std::string figure = figureOf(mean);
    if (figure.empty()) continue;
    std::vector<double> values;
    for (const ReportRow& row : rows)
      if (row.problem.empty() && std::isfinite(row.values[mean.column]))
        values.push_back(row.values[mean.column]);
    const bool isWorstAdded = mean.column == psnrColumn || mean.column == psnrSeenColumn;
    if (!values.empty() && !mean.mayFall && (!state.empty() || !isWorstAdded))
      add("worst_" + figure, std::ranges::min(values), mean.isSeen);
    add("p5_" + figure, percentile(std::move(values), 5), mean.isSeen);
  }
}

/// Adds them for a test and for each of its states.
void addFrames(Table& table, const TestSummary& summary, const MetricSet& metrics) {
  addFrames(table, summary.test, summary.rows, "", metrics);
  std::vector<std::string> states;
  std::map<std::string, std::vector<ReportRow>> rows;
  for (const ReportRow& row : summary.rows) {
    if (!rows.contains(row.state)) states.push_back(row.state);
    rows[row.state].push_back(row);
  }
  for (const std::string& state : states)
    addFrames(table, summary.test, rows[state], state, metrics);
}

}  // namespace

ReportSummary summariseRows(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  ReportSummary summary;
  std::vector<double> sums(4 * metrics.means().size(), 0);
  for (const ReportRow& row : rows) addTo(sums, sumsOf(row, metrics));
  for (std::size_t index = 0; index < rows.size(); ++index) {
    if (!rows[index].problem.empty()) {
      ++summary.withoutView;
      continue;
    }
    const auto take = [&](std::optional<std::size_t>& worst, MetricIndex column) {
      const double mse = rows[index].values[column];
      if (mse > 0 && (!worst || mse > rows[*worst].values[column])) worst = index;
    };
    if (rows[index].values[mseColumn] == 0) ++summary.identical;
    take(summary.worst, mseSeenColumn);
    take(summary.worstFrame, mseColumn);
  }
  const std::vector<double> means = meansOfSums(sums, metrics);
  const auto middle = means.begin() + std::ptrdiff_t(metrics.means().size());
  summary.means.assign(means.begin(), middle);
  summary.weighted.assign(middle, means.end());
  return summary;
}

std::vector<std::string> testsOf(const std::vector<ReportRow>& rows) {
  std::vector<std::string> tests;
  for (const ReportRow& row : rows)
    if (std::find(tests.begin(), tests.end(), row.test) == tests.end()) tests.push_back(row.test);
  return tests;
}

std::vector<TestSummary> summariseTests(const std::vector<ReportRow>& rows,
                                        const MetricSet& metrics,
                                        const std::vector<RateGroup>& groups) {
  std::vector<TestSummary> summaries;
  for (const std::string& test : testsOf(rows)) {
    std::vector<ReportRow> own;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
                 [&](const ReportRow& row) { return row.test == test; });
    summaries.push_back(summaryOf(test, std::move(own), metrics));
    for (const RateGroup& group : groups)
      for (const TestRate& rate : group.tests)
        if (rate.test == test) summaries.back().rate = rate.rate;
  }
  summaries.push_back(summaryOf("all tests", rows, metrics));
  return summaries;
}

bool TestSummary::hasWeights() const {
  return std::ranges::any_of(
      rows, [&](const ReportRow& row) { return row.weight != rows.front().weight; });
}

MeansOfTest TestSummary::means(bool isWeighted) const {
  const std::vector<double>& values = isWeighted ? summary.weighted : summary.means;
  return {values, std::span(intervals).subspan(isWeighted ? values.size() : 0, values.size())};
}

std::vector<BdRow> bdRows(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                          const std::vector<RateGroup>& groups) {
  const RateCurves curves(summaries, metrics, groups);
  const std::vector<double> means = curves.means();
  const std::size_t count = metrics.means().size();
  std::vector<BdRow> rows;
  std::vector<std::pair<BdPair, std::size_t>> known;  // with their row
  for (const BdPair& pair : bdPairs(metrics, groups.size(), curves.haveWeights())) {
    rows.push_back({groups[pair.anchor].name, groups[pair.group].name,
                    metrics.means()[pair.mean % count], curves.deltaOf(pair, means),
                    pair.mean >= count});
    if (rows.back().delta.problem.empty()) known.emplace_back(pair, rows.size() - 1);
  }
  const std::vector<std::vector<double>> units = curves.units();
  if (known.empty() || units.empty()) return rows;
  const auto deltas = [&](const std::vector<double>& sums) {
    const std::vector<double> drawn = meansOfSums(sums, metrics);
    std::vector<double> values;
    for (const auto& [pair, row] : known) {
      const BdDelta delta = curves.deltaOf(pair, drawn);
      values.insert(values.end(), {delta.rate, delta.quality});
    }
    return values;
  };
  const std::vector<Interval> intervals =
      bootstrap(units, deltas, {.resamples = resamplesFor(units.size())});
  for (std::size_t k = 0; k < known.size(); ++k) {
    rows[known[k].second].rate = intervals[2 * k];
    rows[known[k].second].gain = intervals[2 * k + 1];
  }
  return rows;
}

std::string summaryCsv(const std::vector<TestSummary>& summaries, const MetricSet& metrics) {
  Table table =
      csvRows("test,figure,value,low,high,weighted,weighted_low,weighted_high,state,over");
  for (const TestSummary& summary : summaries) {
    addRows(table, summary, metrics);
    if (!summary.rows.empty() && summary.rows.front().frame) addFrames(table, summary, metrics);
  }
  return csvText(table);
}

std::string bdCsv(const std::vector<BdRow>& rows) {
  Table table = csvRows(
      "anchor,group,quality,bd_rate_percent,bd_psnr_db,psnr_from,psnr_to,problem,over,unit,"
      "bd_quality,quality_from,quality_to,means,bd_rate_low,bd_rate_high,bd_quality_low,"
      "bd_quality_high");
  for (const auto& [anchor, group, quality, delta, isWeighted, rate, gain] : rows) {
    const auto decibels = [&, isPsnr = quality.unit == "dB"](double value) {
      return isPsnr ? numberText(value) : std::string();
    };
    table.push_back({anchor, group, quality.name, numberText(delta.rate), decibels(delta.quality),
                     decibels(delta.from), decibels(delta.to), delta.problem,
                     regionOf(quality.isSeen), quality.unit, numberText(delta.quality),
                     numberText(delta.from), numberText(delta.to),
                     isWeighted ? "weighted" : "plain", numberText(rate.low), numberText(rate.high),
                     numberText(gain.low), numberText(gain.high)});
  }
  return csvText(table);
}

}  // namespace hogelscope
