// SPDX-License-Identifier: BSD-3-Clause
// What a report's rows amount to.
#include "core/metrics/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"

namespace hogelscope {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t figureCount = 5;

std::vector<double> listed(const ReportMeans& means) {
  const auto& [psnr, ofMeanMse, ssim, psnrY, psnrYuv] = means;
  return {psnr, ofMeanMse, ssim, psnrY, psnrYuv};
}

/// Plain sums, then weighted ones: one unit of the bootstrap.
std::vector<double> unitOf(const ReportRow& row) {
  const MeanSums plain = meanSums(row, 1);
  const MeanSums weighted = meanSums(row, row.weight);
  std::vector<double> unit(plain.begin(), plain.end());
  unit.insert(unit.end(), weighted.begin(), weighted.end());
  return unit;
}

/// Rows of one state make one unit: what one viewer saw is drawn as a whole.
std::vector<std::vector<double>> unitsOf(const std::vector<ReportRow>& rows) {
  std::vector<std::string> states;
  std::vector<std::vector<double>> units;
  for (const ReportRow& row : rows) {
    const std::vector<double> unit = unitOf(row);
    if (!states.empty() && states.back() == row.state) {  // they stand together in a report
      for (std::size_t k = 0; k < unit.size(); ++k) units.back()[k] += unit[k];
    } else {
      states.push_back(row.state);
      units.push_back(unit);
    }
  }
  return units;
}

std::vector<double> figuresOf(const std::vector<double>& sums) {
  std::vector<double> figures = listed(meansOf(sums.data()));
  const std::vector<double> weighted = listed(meansOf(sums.data() + 2 * figureCount));
  figures.insert(figures.end(), weighted.begin(), weighted.end());
  return figures;
}

TestSummary summaryOf(const std::string& test, std::vector<ReportRow> rows) {
  TestSummary result{test, std::move(rows), {}, {}, {}};
  result.summary = summarise(result.rows);
  result.intervals = bootstrap(unitsOf(result.rows), figuresOf);
  return result;
}

std::string figureRow(const TestSummary& summary, const std::string& figure,
                      const std::vector<double>& values, const std::string& state = {}) {
  std::string text = csvCell(summary.test) + "," + figure;
  for (std::size_t k = 0; k < 6; ++k)
    text += "," + (k < values.size() ? numberText(values[k]) : std::string());
  return text + "," + csvCell(state) + "\n";
}

std::string block(const TestSummary& summary) {
  const std::vector<double> plain = listed(summary.summary);
  const std::vector<double> weighted = listed(summary.summary.weighted);
  std::string text =
      figureRow(summary, "views", {double(summary.rows.size())}) +
      figureRow(summary, "identical_views", {double(summary.summary.identical)}) +
      figureRow(summary, "views_without_comparison", {double(summary.summary.withoutView)});
  for (std::size_t k = 0; k < figureCount; ++k) {
    const Interval& interval = summary.intervals[k];
    const Interval& other = summary.intervals[k + figureCount];
    text += figureRow(summary, figureNames()[k],
                      {plain[k], interval.low, interval.high, weighted[k], other.low, other.high});
  }
  if (summary.summary.worst) {
    const ReportRow& row = summary.rows[*summary.summary.worst];
    text += figureRow(summary, "worst_psnr", {psnr(row.metrics.mse)}, row.state);
  }
  if (summary.rate) text += figureRow(summary, "rate_bpp", {*summary.rate});
  return text;
}

double qualityOf(const std::vector<TestSummary>& summaries, const std::string& test,
                 std::size_t figure) {
  for (const TestSummary& summary : summaries)
    if (summary.test == test) return listed(summary.summary)[figure];
  return nothing;
}

}  // namespace

const std::array<const char*, 5>& figureNames() {
  static const std::array<const char*, 5> names{"mean_psnr", "psnr_of_mean_mse", "mean_ssim",
                                                "mean_psnr_y", "mean_psnr_yuv"};
  return names;
}

std::vector<std::string> testsOf(const std::vector<ReportRow>& rows) {
  std::vector<std::string> tests;
  for (const ReportRow& row : rows)
    if (std::find(tests.begin(), tests.end(), row.test) == tests.end()) tests.push_back(row.test);
  return tests;
}

std::vector<TestSummary> summariseTests(const std::vector<ReportRow>& rows,
                                        const std::vector<RateGroup>& groups) {
  std::vector<TestSummary> summaries;
  for (const std::string& test : testsOf(rows)) {
    std::vector<ReportRow> own;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
                 [&](const ReportRow& row) { return row.test == test; });
    summaries.push_back(summaryOf(test, std::move(own)));
    for (const RateGroup& group : groups)
      for (const TestRate& rate : group.tests)
        if (rate.test == test) summaries.back().rate = rate.rate;
  }
  summaries.push_back(summaryOf("all tests", rows));
  return summaries;
}

std::vector<BdRow> bdRows(const std::vector<TestSummary>& summaries,
                          const std::vector<RateGroup>& groups) {
  const auto curve = [&](const RateGroup& group, std::size_t figure) {
    std::vector<RatePoint> points;
    for (const TestRate& test : group.tests)
      points.push_back({test.rate, qualityOf(summaries, test.test, figure)});
    return points;
  };
  std::vector<BdRow> rows;
  for (std::size_t k = 1; k < groups.size(); ++k)
    for (const std::size_t figure : {0U, 3U, 4U})
      rows.push_back({groups[0].name, groups[k].name, figureNames()[figure],
                      bdDelta(curve(groups[0], figure), curve(groups[k], figure))});
  return rows;
}

std::string summaryCsv(const std::vector<TestSummary>& summaries) {
  std::string text = "test,figure,value,low,high,weighted,weighted_low,weighted_high,state\n";
  for (const TestSummary& summary : summaries) text += block(summary);
  return text;
}

std::string bdCsv(const std::vector<BdRow>& rows) {
  std::string text = "anchor,group,quality,bd_rate_percent,bd_psnr_db,psnr_from,psnr_to,problem\n";
  for (const BdRow& row : rows) {
    text += csvCell(row.anchor) + "," + csvCell(row.group) + "," + row.quality;
    for (const double value :
         {row.delta.rate, row.delta.psnr, row.delta.psnrFrom, row.delta.psnrTo})
      text += "," + numberText(value);
    text += "," + csvCell(row.delta.problem) + "\n";
  }
  return text;
}

}  // namespace hogelscope
