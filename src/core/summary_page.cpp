// SPDX-License-Identifier: BSD-3-Clause
// The summary in words.
#include "core/summary_page.h"

#include <cmath>

#include "core/report_page.h"

namespace hogelscope {

namespace {

std::string cell(const std::string& text) {
  return "<td class=\"n\">" + text + "</td>";
}

/// "31.20 (30.95 … 31.44)".
std::string withInterval(double value, const Interval& interval, int digits) {
  return cell(rounded(value, digits) + " <small>(" + rounded(interval.low, digits) + " … " +
              rounded(interval.high, digits) + ")</small>");
}

std::string tableRow(const TestSummary& test, bool isWeighted) {
  const ReportMeans& m = isWeighted ? test.summary.weighted : test.summary;
  const Interval* interval = &test.intervals[isWeighted ? test.intervals.size() / 2 : 0];
  std::string text =
      "<tr><td>" + escaped(test.test) + (isWeighted ? ", weighted" : "") + "</td>" +
      withInterval(m.meanFinitePsnr, interval[0], 2) +
      withInterval(m.psnrOfMeanMse, interval[1], 2) + withInterval(m.meanSsim, interval[2], 4) +
      withInterval(m.meanPsnrY, interval[3], 2) + withInterval(m.meanPsnrYuv, interval[4], 2);
  if (isWeighted) return text + "<td></td><td></td><td></td></tr>\n";
  text += cell(std::to_string(test.summary.identical) + " of " + std::to_string(test.rows.size()));
  if (!test.summary.worst) return text + "<td></td><td></td></tr>\n";
  const ReportRow& worst = test.rows[*test.summary.worst];
  return text + cell(rounded(psnr(worst.metrics.mse), 2)) + "<td>" + escaped(worst.state) +
         "</td></tr>\n";
}

bool hasWeights(const TestSummary& test) {
  for (const ReportRow& row : test.rows)
    if (row.weight != test.rows.front().weight) return true;
  return false;
}

}  // namespace

std::string bdText(const std::vector<BdRow>& rows) {
  std::string text;
  for (const BdRow& row : rows) {
    text += row.group + " against " + row.anchor + ", " + row.quality + ": ";
    if (!std::isnan(row.delta.rate)) text += "BD-rate " + rounded(row.delta.rate, 2) + " %";
    if (!std::isnan(row.delta.psnr)) text += ", BD-PSNR " + rounded(row.delta.psnr, 2) + " dB";
    if (!row.delta.problem.empty())
      text += (std::isnan(row.delta.rate) ? "no BD-rate: " : "; ") + row.delta.problem;
    text += "\n";
  }
  return text;
}

std::string summaryTables(const std::vector<TestSummary>& summaries,
                          const std::vector<BdRow>& comparisons) {
  std::string text =
      "<h2>Means over the states</h2>\n<p>In brackets 95 % bootstrap intervals. PSNR in dB; means "
      "are of the finite ones.</p>\n<table><tr><th>test</th><th>mean PSNR</th>"
      "<th>PSNR of mean MSE</th><th>mean SSIM</th><th>mean PSNR-Y</th><th>mean PSNR-YUV</th>"
      "<th>identical</th><th>worst PSNR</th><th>worst view</th></tr>\n";
  for (const TestSummary& test : summaries)
    text += tableRow(test, false) + (hasWeights(test) ? tableRow(test, true) : std::string());
  text += "</table>\n";
  if (comparisons.empty()) return text;
  return text + "<h2>Bjøntegaard deltas</h2>\n<pre>" + escaped(bdText(comparisons)) + "</pre>\n";
}

}  // namespace hogelscope
