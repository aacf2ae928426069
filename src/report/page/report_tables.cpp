// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_tables.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "page/html.h"
#include "page/latex_table.h"
#include "report/page/test_names.h"

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
  return text + cell(rounded(worst.values[psnrSeenColumn], 2)) + "<td>" + escaped(viewName(worst)) +
         "</td>";
}

/// The layout of a table: the headlines, with counts and worst views, or all other means.
struct MeansTable {
  const MetricSet& metrics;
  bool isHeadlines;
  bool hasBlind;
  bool hasRates;

  [[nodiscard]] bool has(std::size_t mean) const { return metrics.isHeadline(mean) == isHeadlines; }
};

std::string rateText(const TestSummary& test) {
  return test.rate ? rounded(*test.rate, 4) : std::string("–");
}

std::string tableRow(const TestSummary& test, const std::string& name, const MeansTable& table,
                     bool isWeighted) {
  const auto& [means, intervals] = test.means(isWeighted);
  std::string text = "<tr><td>" + escaped(name) + (isWeighted ? ", weighted" : "") + "</td>";
  if (table.hasRates) text += cell(rateText(test));
  for (std::size_t k = 0; k < means.size(); ++k)
    if (table.has(k))
      text += withInterval(means[k], intervals[k], table.metrics.means()[k].decimals);
  if (!table.isHeadlines) return text + "</tr>\n";
  if (!isWeighted) return text + counts(test, table.hasBlind) + "</tr>\n";
  return text + "<td colspan=\"" + (table.hasBlind ? "4" : "3") + "\"></td></tr>\n";
}

/// Returns the short names of the tests; the last summary, of all tests, has none.
std::vector<std::string> namesOf(const std::vector<TestSummary>& summaries) {
  std::vector<std::string> tests;
  for (std::size_t k = 0; k + 1 < summaries.size(); ++k) tests.push_back(summaries[k].test);
  return figureNames(tests);
}

std::string tableOf(const std::vector<TestSummary>& summaries, const MeansTable& table) {
  std::string text = "<div class=\"scroll\"><table class=\"means\"><thead><tr><th>test</th>";
  if (table.hasRates) text += "<th class=\"n\">bits a directional pixel</th>";
  for (std::size_t k = 0; k < table.metrics.means().size(); ++k)
    if (table.has(k))
      text += "<th class=\"n\">" + escaped(titleOf(table.metrics.means()[k])) + "</th>";
  if (table.isHeadlines) {
    text += "<th class=\"n\">identical</th>";
    if (table.hasBlind) text += "<th class=\"n\">nothing to compare</th>";
    text += "<th class=\"n\">worst PSNR</th><th>worst view</th>";
  }
  text += "</tr></thead>\n<tbody>\n";
  const std::vector<std::string> names = namesOf(summaries);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (summaries[k].hasWeights()) text += tableRow(summaries[k], names[k], table, true);
    text += tableRow(summaries[k], names[k], table, false);
  }
  return text + "</tbody></table></div>\n";
}

/// Returns the same table as LaTeX: tests, rates and means with their intervals; weighted means
/// where states have weights.
std::string latexOf(const std::vector<TestSummary>& summaries, const MeansTable& table) {
  Table rows{{"test"}};
  if (table.hasRates) rows[0].emplace_back("bpp");
  for (std::size_t k = 0; k < table.metrics.means().size(); ++k)
    if (table.has(k)) rows[0].push_back(titleOf(table.metrics.means()[k]));
  const std::vector<std::string> names = namesOf(summaries);
  for (std::size_t test = 0; test < names.size(); ++test) {
    const TestSummary& of = summaries[test];
    const bool isWeighted = of.hasWeights();
    const auto& [means, intervals] = of.means(isWeighted);
    rows.push_back({names[test] + (isWeighted ? ", weighted" : "")});
    if (table.hasRates) rows.back().push_back(rateText(of));
    for (std::size_t k = 0; k < means.size(); ++k) {
      if (table.has(k))
        rows.back().push_back(
            withRange(means[k], intervals[k], table.metrics.means()[k].decimals, ""));
    }
  }
  return latexTable(rows);
}

/// Returns the columns of the table.
std::vector<std::size_t> pageColumns(const MetricSet& metrics) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < metrics.columns().size(); ++k)
    if (metrics.columns()[k].where >= MetricColumn::Where::page) columns.push_back(k);
  return columns;
}

std::string stateRow(const ReportRow& row, const std::string& test, const MetricSet& metrics) {
  const std::vector<std::size_t> columns = pageColumns(metrics);
  std::string text = "<tr><td>" + escaped(viewName(row)) + "</td><td>" + escaped(test) + "</td>";
  if (!row.problem.empty())
    return text + "<td colspan=\"" + std::to_string(columns.size()) + "\" class=\"problem\">" +
           escaped(row.problem) + "</td></tr>\n";
  for (const std::size_t k : columns) text += cell(tableText(metrics.columns()[k], row.values[k]));
  return text + "</tr>\n";
}

MeansTable meansTableOf(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                        bool isHeadlines) {
  return {metrics, isHeadlines, summaries.back().summary.withoutView > 0,
          std::ranges::any_of(summaries,
                              [](const TestSummary& test) { return test.rate.has_value(); })};
}

/// The cells of a comparison, for the page and for LaTeX.
std::vector<std::string> cellsOf(const BdRow& row) {
  const int decimals = row.quality.decimals;
  return {row.group,
          row.anchor,
          titleOf(row.quality) + (row.isWeighted ? ", weighted" : ""),
          withRange(row.delta.rate, row.rate, 2, ""),
          withRange(row.delta.quality, row.gain, decimals, ""),
          rounded(row.delta.from, decimals) + " … " + rounded(row.delta.to, decimals)};
}

const std::vector<std::string> bdHeads{"group",        "against",       "quality",
                                       "BD-rate in %", "at equal rate", "over the range"};

/// Returns the comparisons by headlines.
std::vector<BdRow> headlinesOf(const std::vector<BdRow>& rows, const MetricSet& metrics) {
  std::vector<BdRow> chosen;
  for (const BdRow& row : rows)
    for (std::size_t k = 0; k < metrics.means().size(); ++k)
      if (metrics.means()[k].name == row.quality.name && metrics.isHeadline(k))
        chosen.push_back(row);
  return chosen;
}

}  // namespace

std::string withRange(double value, const Interval& interval, int digits, const std::string& unit) {
  std::string text = rounded(value, digits) + unit;
  if (!std::isnan(interval.low))
    text += " (" + rounded(interval.low, digits) + " … " + rounded(interval.high, digits) + ")";
  return text;
}

std::string bdText(const std::vector<BdRow>& rows, const MetricSet& metrics) {
  std::string text;
  for (const BdRow& row : headlinesOf(rows, metrics)) {
    const std::string unit = row.quality.unit.empty() ? "" : " " + row.quality.unit;
    text += row.group + " against " + row.anchor + ", " + row.quality.name +
            (row.isWeighted ? ", weighted: " : ": ");
    if (!std::isnan(row.delta.rate))
      text += "BD-rate " + withRange(row.delta.rate, row.rate, 2, " %");
    if (!std::isnan(row.delta.quality))
      text +=
          ", at equal rate " + withRange(row.delta.quality, row.gain, row.quality.decimals, unit);
    if (!row.delta.problem.empty())
      text += (std::isnan(row.delta.rate) ? "no BD-rate: " : "; ") + row.delta.problem;
    text += "\n";
  }
  return text;
}

std::string testsText(const std::vector<TestSummary>& summaries) {
  std::string text;
  const std::vector<std::string> names = namesOf(summaries);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const TestSummary& test = summaries[k];
    const bool isWeighted = test.hasWeights();
    const auto& [means, intervals] = test.means(isWeighted);
    text += printable(names[k]) + ": " + (test.rate ? rateText(test) + " bits, " : "") +
            (isWeighted ? "weighted " : "") + "mean PSNR " +
            withRange(means[meanPsnrSeen], intervals[meanPsnrSeen], 2,
                      std::isfinite(means[meanPsnrSeen]) ? " dB" : "") +
            ", mean SSIM " + rounded(means[meanSsimSeen], 4);
    if (test.summary.worst) {
      const ReportRow& worst = test.rows[*test.summary.worst];
      text += ", worst " + rounded(worst.values[psnrSeenColumn], 2) + " dB: " + viewName(worst);
    }
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
    text += "worst view                " + decibels(row.values[psnrSeenColumn]) + ": " +
            viewName(row) + ", " + printable(row.test) + "\n";
  }
  text += "identical views           " + std::to_string(summary.identical) + of;
  if (summary.withoutView == 0) return text;
  return text + "nothing to compare        " + std::to_string(summary.withoutView) + of;
}

std::string meansTable(const std::vector<TestSummary>& summaries, const MetricSet& metrics) {
  return "<p>Means over the states, of the pixels seen in both pictures; in brackets 95 % "
         "bootstrap "
         "intervals. Means are of the finite PSNRs.</p>\n" +
         tableOf(summaries, meansTableOf(summaries, metrics, true)) +
         latexPart(meansTex(summaries, metrics));
}

std::string frameTable(const std::vector<TestSummary>& summaries, const MetricSet& metrics) {
  const MeansTable table = meansTableOf(summaries, metrics, false);
  return tableOf(summaries, table) + latexPart(latexOf(summaries, table));
}

std::string meansTex(const std::vector<TestSummary>& summaries, const MetricSet& metrics) {
  return latexOf(summaries, meansTableOf(summaries, metrics, true));
}

std::string bdTex(const std::vector<BdRow>& rows, const MetricSet& metrics) {
  Table table{bdHeads};
  for (const BdRow& row : headlinesOf(rows, metrics)) table.push_back(cellsOf(row));
  return latexTable(table);
}

std::string bdTable(const std::vector<BdRow>& rows, const MetricSet& metrics) {
  std::string table =
      "<p>Additional bits at equal quality, and gain of quality at equal rate; in brackets 95 % "
      "bootstrap intervals over the states. Other qualities are in bd.csv.</p>\n"
      "<div class=\"scroll\"><table class=\"means\"><thead><tr>";
  for (const std::string& head : bdHeads) table += "<th>" + head + "</th>";
  table += "</tr></thead>\n<tbody>\n";
  for (const BdRow& row : headlinesOf(rows, metrics)) {
    table += "<tr>";
    const std::vector<std::string> cells = cellsOf(row);
    for (std::size_t k = 0; k < cells.size(); ++k)
      table += k < 3 ? "<td>" + escaped(cells[k]) + "</td>" : cell(cells[k]);
    table += "</tr>\n";
    if (!row.delta.problem.empty())
      table +=
          "<tr><td colspan=\"6\" class=\"problem\">" + escaped(row.delta.problem) + "</td></tr>\n";
  }
  return table + "</tbody></table></div>\n" + latexPart(bdTex(rows, metrics));
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
  const std::vector<std::string> names = figureNames(testsOf(rows));
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += stateRow(rows[k], names[k % names.size()], metrics);
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
