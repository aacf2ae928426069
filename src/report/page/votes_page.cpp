// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/votes_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "page/figure.h"
#include "page/html.h"
#include "page/latex_table.h"

namespace hogelscope {

namespace {

/// A cell with `digits` behind the point; a dash for what is not known.
std::string cellOf(double value, int digits = 2) {
  if (std::isnan(value)) return "–";
  const double scale = std::pow(10, digits);
  return numberText(std::round(value * scale) / scale);
}

std::string tableTag(const Table& table, std::size_t texts) {
  std::string text = "<div class=\"scroll\"><table class=\"sorts\">";
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::string tag = row == 0 ? "th" : "td";
    text += row == 0 ? "<thead><tr>" : "<tr>";
    for (std::size_t k = 0; k < table[row].size(); ++k)
      text += "<" + tag + (k < texts ? ">" : " class=\"n\">") + escaped(table[row][k]) + "</" +
              tag + ">";
    text += row == 0 ? "</tr></thead><tbody>\n" : "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

double scoreOf(const VotesReport& report, const VoteRow& row) {
  return report.votes.arePairs ? row.strength : row.mos;
}

/// The tests in the order in which the page numbers them.
std::vector<std::string> testsOf(const VotesReport& report) {
  std::vector<std::string> tests;
  for (const VoteRow& row : report.rows)
    if (row.state == report.rows.back().state) tests.push_back(row.test);
  return tests;
}

std::size_t numberOfTest(const std::vector<std::string>& tests, const std::string& test) {
  return std::size_t(std::ranges::find(tests, test) - tests.begin()) + 1;
}

const char* scoreTitle(const VotesReport& report) {
  return report.votes.arePairs ? "strength, ln of the odds" : "mean opinion score";
}

/// The scores over the tests: a curve for each state.
Figure scoresFigure(const VotesReport& report) {
  const std::vector<std::string> tests = testsOf(report);
  Plot plot;
  plot.titleAcross = "test, by its number in the table";
  plot.titleUp = scoreTitle(report);
  plot.leastRange = {1, 1};
  plot.hasCurves = true;
  Table points{{"state", "number", "test", "score", "low", "high"}};
  for (std::size_t k = 0; k < report.rows.size(); ++k) {
    const VoteRow& row = report.rows[k];
    if (plot.series.empty() || plot.series.back().name != row.state)
      plot.series.push_back({.name = row.state, .points = {}});
    const auto number = numberOfTest(tests, row.test);
    plot.series.back().points.push_back({.across = double(number),
                                         .up = scoreOf(report, row),
                                         .title = row.test,
                                         .row = k,
                                         .interval = row.interval});
    points.push_back({row.state, std::to_string(number), row.test, numberCell(scoreOf(report, row)),
                      numberCell(row.interval.low), numberCell(row.interval.high)});
  }
  Figure figure = figureOf(plot, "votes", "Votes on each test", csvText(points));
  figure.caption = "Bars are 95 % intervals.";
  return figure;
}

/// The scores over a metric: a mark for each state and test.
Figure metricFigure(const VotesReport& report, const VotesCorrelation& of) {
  Plot plot;
  plot.titleAcross = of.metric;
  plot.titleUp = scoreTitle(report);
  Plot::Series series{.name = of.metric, .points = {}};
  for (std::size_t k = 0; k < of.rows.size(); ++k) {
    const VoteRow& row = report.rows[of.rows[k]];
    series.points.push_back({.across = of.values[k],
                             .up = scoreOf(report, row),
                             .title = row.state + ", " + row.test,
                             .row = of.rows[k]});
  }
  plot.series.push_back(std::move(series));
  return figureOf(plot, of.metric, "Votes over " + of.metric, "");
}

std::string scoresTable(const VotesReport& report) {
  const std::vector<std::string> tests = testsOf(report);
  Table table{
      {"state", "test", "no.", "votes", report.votes.arePairs ? "strength" : "MOS", "low", "high"}};
  for (const VoteRow& row : report.rows)
    table.push_back({row.state, row.test, std::to_string(numberOfTest(tests, row.test)),
                     std::to_string(row.n), cellOf(scoreOf(report, row)), cellOf(row.interval.low),
                     cellOf(row.interval.high)});
  return tableTag(table, 2) + latexPart(latexTable(table));
}

std::string metricsPart(const VotesReport& report) {
  if (report.correlations.empty()) return {};
  Table table{{"metric", "n", "PLCC", "SROCC"}};
  for (const auto& [metric, n, plcc, srocc, rows, values] : report.correlations)
    table.push_back({metric, std::to_string(n), cellOf(plcc, 3), cellOf(srocc, 3)});
  std::string text =
      "<h2>Votes and metrics</h2>\n<p>Over the states and tests of votes that the report has, too: "
      "Pearson's correlation (PLCC), without a fitted curve, and Spearman's of the ranks (SROCC). "
      "Identical pictures, whose PSNR is infinite, are left out.</p>\n";
  for (const VotesCorrelation& one : report.correlations)
    if ((one.metric == "psnr_seen" || one.metric == "ssim_seen") && one.n > 0)
      text += figureTag(metricFigure(report, one));
  return text + tableTag(table, 1) + latexPart(latexTable(table));
}

std::string viewersPart(const VotesReport& report) {
  Table table{{"viewer", "answers", "minutes", "pixels per degree", "left out"}};
  for (const auto& [name, answers, seconds, density, isScreened] : report.viewers)
    table.push_back({name, std::to_string(answers), cellOf(seconds / 60, 1), cellOf(density, 1),
                     isScreened ? "yes" : ""});
  return "<h2>Viewers</h2>\n" + tableTag(table, 1);
}

}  // namespace

std::string votesPage(const VotesReport& report) {
  std::string body = "<h1>Votes</h1>\n<p>" + std::to_string(report.votes.votes.size()) +
                     " answers of " + std::to_string(report.votes.viewers.size()) + " viewers. ";
  body +=
      report.votes.arePairs
          ? "They said which of two looks better. The difference of two strengths is the natural "
            "logarithm of the odds that the one is preferred to the other (Bradley and Terry); "
            "their mean is 0. Intervals are by the bootstrap over viewers."
          : "They graded each test beside the reference: 5 imperceptible, 4 perceptible but "
            "not annoying, 3 slightly annoying, 2 annoying, 1 very annoying (ITU-R BT.500). "
            "Intervals are Student's; over all states they are of the viewers' means.";
  for (const std::string& note : report.notes) body += " " + escaped(note);
  body += "</p>\n" + figureTag(scoresFigure(report)) + scoresTable(report) + metricsPart(report) +
          viewersPart(report);
  return pageOf("Hogelscope votes", body);
}

}  // namespace hogelscope
