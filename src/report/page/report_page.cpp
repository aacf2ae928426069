// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_page.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/metrics/statistics.h"
#include "page/html.h"
#include "report/page/report_plots.h"
#include "report/page/summary_page.h"

namespace hogelscope {

namespace {

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
  for (const std::size_t k : columns)
    text += "<td class=\"n\">" + tableText(metrics.columns()[k], row.values[k]) + "</td>";
  return text + "</tr>\n";
}

}  // namespace

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

namespace {

std::string fact(const std::string& name, const std::string& value) {
  return "<tr><th scope=\"row\">" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>\n";
}

std::string displayWords(const PanelParams& d) {
  const auto pair = [](const auto& values) {
    return numberText(values[0]) + " × " + numberText(values[1]);
  };
  return pair(d.size) + " m, " + pair(d.hogels) + " hogels of " + pair(d.directions) +
         " directions, field of view " + pair(d.fov) + "°, " +
         (d.lens == HogelLensModel::plugin
              ? "lenses of the plugin " + d.lensSource
              : std::string(hogelLensNames()[std::size_t(d.lens)]) + " hogel lenses") +
         (d.viewingDistance > 0 ? ", converging at " + numberText(d.viewingDistance) + " m" : "");
}

std::string whatWasTested(const ReportPage& page) {
  std::string text = "<h2>What was tested</h2>\n<table class=\"facts\"><tbody>\n";
  for (const ReportFact& one : page.facts) text += fact(one.name, one.value);
  return text + fact("Display", displayWords(page.display)) + "</tbody></table>\n";
}

std::string overPosition(const ReportPage& page) {
  return "<h2>PSNR over camera position</h2>\n<p>In the display's frame, in metres: the panel's "
         "middle is at 0. Filled: coloured by PSNR; hollow: identical; cross: nothing to compare; "
         "one scale for all tests; PSNR of the pixels seen. "
         "The pointer over a point shows its name and figures.</p>\n" +
         cameraMaps(page.rows, page.display) + anglePlot(page.rows, page.display);
}

/// Returns the rank correlation of the views' own quality and the perceived one over the tests.
std::string orderOfTests(const ReportPage& page) {
  std::vector<double> own;
  std::vector<double> perceived;
  for (const ReportPanel& panel : page.panels)
    for (const TestSummary& test : page.summaries)
      if (!panel.views.empty() && test.test == panel.test) {
        own.push_back(panel.agreement.meanPsnr);
        perceived.push_back(test.summary.means[meanPsnrSeen]);
      }
  if (own.size() < 3) return {};
  return "<p>Over the " + std::to_string(own.size()) +
         " tests, the rank correlation (Spearman) of the mean PSNR of the light field's own views "
         "and the mean PSNR seen is " +
         rounded(rankCorrelation(own, perceived), 2) + ".</p>\n";
}

std::string errorOnPanel(const ReportPage& page) {
  return "<h2>Where the error comes from</h2>\n<p>Each pixel that both pictures see counts for the "
         "hogel and for the direction that the ray through its centre meets. Colours show the mean "
         "squared error (MSE) of all such pixels of all states, from 0 to the 99th percentile of "
         "the cells; grey: no pixel met it. Costliest is what holds most of the squared error; "
         "hogel (0, 0) is the top left one. The second row of pictures has the error of the light "
         "field's own views (sub-aperture images), by which codecs are usually judged; yellow in "
         "the "
         "last one: perceived worse than its own error tells. View (0, 0) is the top left "
         "one.</p>\n" +
         orderOfTests(page) + panelFigures(page.panels, page.display);
}

constexpr const char* definitions =
    R"html(<h2>How to read the figures</h2>
<dl>
<dt>MSE, PSNR</dt><dd>Mean of the squared differences of RGB, in code values from 0 to 255, with the
fractions of light fields of more than 8 bits; PSNR = 10 log10(255²/MSE) in dB, which is that of the
peak of any other number of bits.</dd>
<dt>Seen, frame</dt><dd>“Seen” is over the pixels that both pictures see, and so is all that is not called
“frame”, which is over the whole picture: black surroundings, which no light field gets wrong, raise its
PSNR. “Seen %” is the share of the pixels seen.</dd>
<dt>Identical</dt><dd>MSE is 0, so that PSNR is infinite. Identical views are counted, and are in no mean
of PSNRs.</dd>
<dt>Mean PSNR, PSNR of mean MSE</dt><dd>The first is the mean of the finite PSNRs; the second is the PSNR
of the mean MSE, identical views included. They differ, and bad views weigh more in the second.</dd>
<dt>PSNR-Y, PSNR-YUV</dt><dd>PSNR of the luma of BT.709 in full range; and
(6 PSNR-Y + PSNR-Cb + PSNR-Cr)/8.</dd>
<dt>SSIM</dt><dd>Structural similarity as Wang et al. 2004 have it, on luma, with an 11×11 Gaussian window
of σ 1.5; 1 is identical. “Seen” is the mean over the windows that hold only pixels seen.</dd>
<dt>Intervals</dt><dd>95 % percentile bootstrap over the states, 10 000 resamples (fewer of more than 2000
states, at least 1000): how a mean would vary with other camera positions of the same kind, not with other scenes.</dd>
<dt>Weighted</dt><dd>The same mean with each view counted by its state's weight.</dd>
</dl>
)html";

}  // namespace

std::string html(const ReportPage& page) {
  const std::string title = escaped(page.session);
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      std::string(pagePolicy) +
      "\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>Hogelscope report: " +
      title + "</title>\n<style>" + pageStyle + "</style></head><body>\n" +
      "<h1>Perceived views of " + title + "</h1>\n" + summaryTables(page.summaries, page.metrics);
  if (!page.groups.empty())
    text +=
        "<h2>Quality over rate</h2>\n<p>Means over the states with 95 % bootstrap intervals; over "
        "the pixels seen, but for metrics of plugins. The pointer over a point shows its "
        "figures.</p>\n" +
        ratePlots(page.summaries, page.metrics, page.groups);
  if (!page.comparisons.empty())
    text += "<h2>Bjøntegaard deltas</h2>\n" + bdTable(page.comparisons);
  if (!page.rows.empty()) text += overPosition(page);
  if (!page.views.empty())
    text += "<h2>Worst, median and best views</h2>\n" + viewFigures(page.views, page.rows);
  if (!page.panels.empty()) text += errorOnPanel(page);
  if (!page.rows.empty()) text += "<h2>All states</h2>\n" + statesTable(page.rows, page.metrics);
  if (!page.lenses.empty())
    text += "<h2>How far the lenses can be trusted</h2>\n" + lensesTable(page.lenses);
  return text + definitions + whatWasTested(page) + "<script>" + pageScript +
         "</script>\n</body></html>\n";
}

}  // namespace hogelscope
