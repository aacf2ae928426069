// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_tables.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "page/html.h"

namespace hogelscope {

namespace {

std::string cell(const std::string& text) {
  return "<td class=\"n\">" + text + "</td>";
}

/// Returns a cell such as "31.20 (30.95 … 31.44)".
std::string withInterval(double value, const Interval& interval, int digits) {
  return cell(rounded(value, digits) + " <small>(" + rounded(interval.low, digits) + " … " +
              rounded(interval.high, digits) + ")</small>");
}

/// Returns a title such as "mean PSNR in dB".
std::string titleOf(const MetricMean& mean) {
  return mean.title + (mean.unit.empty() ? "" : " in " + mean.unit);
}

/// Returns the cells that only the row of unweighted means has.
std::string counts(const TestSummary& test, bool hasBlind) {
  const auto of = " of " + std::to_string(test.rows.size());
  std::string text = cell(std::to_string(test.summary.identical) + of);
  if (hasBlind) text += cell(std::to_string(test.summary.withoutView) + of);
  if (!test.summary.worst) return text + "<td></td><td></td>";
  const ReportRow& worst = test.rows[*test.summary.worst];
  return text + cell(rounded(worst.values[psnrSeenColumn], 2)) + "<td>" + escaped(worst.state) +
         "</td>";
}

/// The layout of a table: means over the seen pixels, with counts and worst views, or all others.
struct MeansTable {
  const MetricSet& metrics;
  bool isSeen;
  bool hasBlind;
  bool hasRates;
};

std::string rateText(const TestSummary& test) {
  return test.rate ? rounded(*test.rate, 4) : std::string("–");
}

std::string tableRow(const TestSummary& test, const MeansTable& table, bool isWeighted) {
  const std::vector<double>& means = isWeighted ? test.summary.weighted : test.summary.means;
  const Interval* intervals = &test.intervals[isWeighted ? means.size() : 0];
  std::string text = "<tr><td>" + escaped(test.test) + (isWeighted ? ", weighted" : "") + "</td>";
  if (table.hasRates) text += cell(rateText(test));
  for (std::size_t k = 0; k < means.size(); ++k)
    if (table.metrics.means()[k].isSeen == table.isSeen)
      text += withInterval(means[k], intervals[k], table.metrics.means()[k].decimals);
  if (!table.isSeen) return text + "</tr>\n";
  if (!isWeighted) return text + counts(test, table.hasBlind) + "</tr>\n";
  return text + "<td colspan=\"" + (table.hasBlind ? "4" : "3") + "\"></td></tr>\n";
}

bool hasWeights(const TestSummary& test) {
  return std::ranges::any_of(
      test.rows, [&](const ReportRow& row) { return row.weight != test.rows.front().weight; });
}

std::string tableOf(const std::vector<TestSummary>& summaries, const MeansTable& table) {
  std::string text = "<div class=\"scroll\"><table class=\"means\"><thead><tr><th>test</th>";
  if (table.hasRates) text += "<th class=\"n\">bits a directional pixel</th>";
  for (const MetricMean& mean : table.metrics.means())
    if (mean.isSeen == table.isSeen) text += "<th class=\"n\">" + escaped(titleOf(mean)) + "</th>";
  if (table.isSeen) {
    text += "<th class=\"n\">identical</th>";
    if (table.hasBlind) text += "<th class=\"n\">nothing to compare</th>";
    text += "<th class=\"n\">worst PSNR</th><th>worst view</th>";
  }
  text += "</tr></thead>\n<tbody>\n";
  const std::size_t shown = summaries.size() == 2 ? 1 : summaries.size();  // equal for one test
  for (std::size_t k = 0; k < shown; ++k) {
    text += tableRow(summaries[k], table, false);
    if (hasWeights(summaries[k])) text += tableRow(summaries[k], table, true);
  }
  return text + "</tbody></table></div>\n";
}

/// Returns the same table as LaTeX: tests, rates and means with their intervals.
std::string latexOf(const std::vector<TestSummary>& summaries, const MeansTable& table) {
  std::vector<std::string> heads{"test"};
  if (table.hasRates) heads.emplace_back("bpp");
  for (const MetricMean& mean : table.metrics.means())
    if (mean.isSeen == table.isSeen) heads.push_back(titleOf(mean));
  std::vector<std::vector<std::string>> rows;
  const std::size_t shown = summaries.size() == 2 ? 1 : summaries.size();
  for (std::size_t test = 0; test < shown; ++test) {
    rows.push_back({summaries[test].test});
    if (table.hasRates) rows.back().push_back(rateText(summaries[test]));
    for (std::size_t k = 0; k < table.metrics.means().size(); ++k) {
      const MetricMean& mean = table.metrics.means()[k];
      if (mean.isSeen != table.isSeen) continue;
      const auto number = [&](double value) { return rounded(value, mean.decimals); };
      const Interval& interval = summaries[test].intervals[k];
      rows.back().push_back(number(summaries[test].summary.means[k]) + " (" + number(interval.low) +
                            "–" + number(interval.high) + ")");
    }
  }
  return latexTable(heads, rows);
}

/// Returns the columns of the table.
std::vector<std::size_t> pageColumns(const MetricSet& metrics) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < metrics.columns().size(); ++k)
    if (metrics.columns()[k].where >= MetricColumn::Where::page) columns.push_back(k);
  return columns;
}

std::string stateRow(const ReportRow& row, const MetricSet& metrics) {
  const std::vector<std::size_t> columns = pageColumns(metrics);
  std::string text = "<tr><td>" + escaped(row.state) + "</td><td>" + escaped(row.test) + "</td>";
  if (!row.problem.empty())
    return text + "<td colspan=\"" + std::to_string(columns.size()) + "\" class=\"problem\">" +
           escaped(row.problem) + "</td></tr>\n";
  for (const std::size_t k : columns) text += cell(tableText(metrics.columns()[k], row.values[k]));
  return text + "</tr>\n";
}

}  // namespace

std::string bdText(const std::vector<BdRow>& rows) {
  std::string text;
  for (const BdRow& row : rows) {
    text += row.group + " against " + row.anchor + ", " + row.quality.name + ": ";
    if (!std::isnan(row.delta.rate)) text += "BD-rate " + rounded(row.delta.rate, 2) + " %";
    if (!std::isnan(row.delta.quality))
      text += ", at equal rate " + rounded(row.delta.quality, row.quality.decimals) +
              (row.quality.unit.empty() ? "" : " " + row.quality.unit);
    if (!row.delta.problem.empty())
      text += (std::isnan(row.delta.rate) ? "no BD-rate: " : "; ") + row.delta.problem;
    text += "\n";
  }
  return text;
}

std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows) {
  const auto decibels = [](double value) {
    return rounded(value, 2) + (std::isfinite(value) ? " dB" : "");
  };
  const auto both = [&](double seen, double frame) {
    return decibels(seen) + " over what is seen, " + decibels(frame) + " over the whole frame";
  };
  const std::vector<double>& means = summary.means;
  const std::string of = " of " + std::to_string(rows.size()) + "\n";
  std::string text = "mean of the finite PSNRs  " + both(means[meanPsnrSeen], means[meanPsnr]) +
                     "\n" + "PSNR of the mean MSE      " +
                     both(means[psnrOfMeanMseSeen], means[psnrOfMeanMse]) + "\n";
  if (summary.worst) {
    const ReportRow& row = rows[*summary.worst];
    text += "worst view                " + decibels(row.values[psnrSeenColumn]) + ": " + row.state +
            ", " + printable(row.test) + "\n";
  }
  text += "identical views           " + std::to_string(summary.identical) + of;
  if (summary.withoutView == 0) return text;
  return text + "nothing to compare        " + std::to_string(summary.withoutView) + of;
}

std::string summaryTables(const std::vector<TestSummary>& summaries, const MetricSet& metrics) {
  if (summaries.empty()) return {};
  const bool hasBlind = summaries.back().summary.withoutView > 0;
  const bool hasRates =
      std::ranges::any_of(summaries, [](const TestSummary& test) { return test.rate.has_value(); });
  const MeansTable seen{metrics, true, hasBlind, hasRates};
  const MeansTable frame{metrics, false, hasBlind, hasRates};
  return "<h2>Means over the states</h2>\n<p>Over the pixels seen in both pictures. In brackets 95 "
         "% "
         "bootstrap intervals. Means are of the finite PSNRs.</p>\n" +
         tableOf(summaries, seen) + latexOf(summaries, seen) +
         "<h3>The same over the whole frame, black surroundings included</h3>\n" +
         tableOf(summaries, frame) + latexOf(summaries, frame);
}

std::string bdTable(const std::vector<BdRow>& rows) {
  const std::vector<std::string> heads{"group",   "against",       "quality", "over",
                                       "BD-rate", "at equal rate", "from",    "to"};
  std::string table = "<div class=\"scroll\"><table class=\"means\"><thead><tr>";
  for (const std::string& head : heads) table += "<th>" + head + "</th>";
  table += "</tr></thead>\n<tbody>\n";
  std::vector<std::vector<std::string>> cells;
  for (const auto& [anchor, group, quality, delta] : rows) {
    cells.push_back({group, anchor, titleOf(quality), quality.isSeen ? "seen" : "frame"});
    table += "<tr>";
    for (const std::string& text : cells.back()) table += "<td>" + escaped(text) + "</td>";
    for (const std::string& number :
         {rounded(delta.rate, 2) + (std::isnan(delta.rate) ? "" : " %"),
          rounded(delta.quality, quality.decimals), rounded(delta.from, quality.decimals),
          rounded(delta.to, quality.decimals)}) {
      cells.back().push_back(number);
      table += cell(number);
    }
    table += "</tr>\n";
    if (!delta.problem.empty())
      table += "<tr><td colspan=\"8\" class=\"problem\">" + escaped(delta.problem) + "</td></tr>\n";
  }
  return table + "</tbody></table></div>\n" + latexTable(heads, cells);
}

std::string statesTable(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  std::string text =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>state</th><th>test</th>";
  for (const std::size_t k : pageColumns(metrics)) {
    const MetricColumn& column = metrics.columns()[k];
    text += "<th class=\"n\">" +
            escaped(column.title + (column.unit.empty() ? "" : " " + column.unit)) + "</th>";
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const ReportRow& row : rows) text += stateRow(row, metrics);
  return text + "</tbody></table></div>\n";
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t named = 2;
  if (names.size() == 1) return names[0];
  std::string text;
  const std::size_t shown = std::min(named, names.size() - 1);
  for (std::size_t k = 0; k < shown; ++k) text += (k == 0 ? "" : ", ") + names[k];
  const std::size_t rest = names.size() - shown;
  if (rest == 1) return text + " and " + names.back();
  return text + " and " + std::to_string(rest) + " others";
}

std::string lensesTable(const std::vector<ReportLens>& lenses) {
  std::vector<std::string> certificates;
  std::vector<std::vector<std::string>> states;
  for (const ReportLens& lens : lenses) {
    const std::string words = certificateText(lens.certificate);
    const auto same = std::find(certificates.begin(), certificates.end(), words);
    const auto at = std::size_t(same - certificates.begin());
    if (same == certificates.end()) {
      certificates.push_back(words);
      states.emplace_back();
    }
    states[at].push_back(lens.state);
  }
  std::string table =
      "<table><thead><tr><th>states</th><th>their lens</th></tr></thead>\n<tbody>\n";
  for (std::size_t k = 0; k < certificates.size(); ++k)
    table += "<tr><td>" + escaped(listed(states[k])) + "</td><td>" + escaped(certificates[k]) +
             "</td></tr>\n";
  return table + "</tbody></table>\n";
}

}  // namespace hogelscope
