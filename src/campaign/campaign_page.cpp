// SPDX-License-Identifier: BSD-3-Clause
#include "campaign/campaign_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "page/figure.h"
#include "page/html.h"
#include "page/latex_table.h"
#include "report/page/report_tables.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

constexpr const char* meanRow = "mean of scenes";

/// Returns the comparisons of a quality with the first group: those of the page's tables.
std::vector<const BdOverScenes*> mainComparisons(const CampaignResult& result) {
  std::vector<const BdOverScenes*> main;
  const std::vector<BdOverScenes>& all = result.over.comparisons;
  if (result.groups.empty()) return main;
  const bool areWeighted = std::ranges::any_of(all, &BdOverScenes::isWeighted);
  for (const BdOverScenes& one : all)
    if (one.quality.name == result.metrics.means()[meanPsnrSeen].name &&
        one.isWeighted == areWeighted && one.anchor == result.groups.front())
      main.push_back(&one);
  return main;
}

std::string percent(double value) {
  return std::isnan(value) ? "–" : withMinus(rounded(value, 2)) + " %";
}

/// Scenes × groups: BD-rates, and their mean over the scenes.
Table deltaTable(const CampaignResult& result) {
  const std::vector<const BdOverScenes*> main = mainComparisons(result);
  Table table{{"scene"}};
  for (const BdOverScenes* one : main) table[0].push_back(one->group + " against " + one->anchor);
  for (std::size_t scene = 0; scene < result.scenes.size(); ++scene) {
    table.push_back({result.scenes[scene]});
    for (const BdOverScenes* one : main) table.back().push_back(percent(one->ofScenes[scene]));
  }
  table.push_back({meanRow});
  for (const BdOverScenes* one : main)
    table.back().push_back(withMinus(withRange(one->rate, one->rateInterval, 2, " %")));
  return table;
}

/// Tests × columns: means over the scenes.
Table testTable(const CampaignResult& result) {
  const std::vector<MetricMean>& means = result.metrics.means();
  Table table{{"test"}};
  for (const TestOverScenes& test : result.over.tests) table.push_back({test.test});
  for (const std::string& name : result.columns) {
    const auto mean = std::ranges::find(means, name, &MetricMean::name);
    const bool isMean = mean != means.end();
    const auto k = std::size_t(mean - means.begin());
    table[0].push_back(!isMean              ? "scenes"
                       : mean->unit.empty() ? mean->title
                                            : mean->title + " in " + mean->unit);
    for (std::size_t test = 0; test < result.over.tests.size(); ++test) {
      const TestOverScenes& of = result.over.tests[test];
      table[test + 1].push_back(
          isMean ? withMinus(withRange(of.means[k], of.intervals[k], mean->decimals, ""))
                 : std::to_string(of.scenes));
    }
  }
  return table;
}

/// Returns a table of the page; the first cell of a row leads to the report of that scene.
std::string htmlOf(const Table& table, const std::vector<std::string>& scenes) {
  std::string text = "<div class=\"scroll\"><table class=\"means\"><thead><tr>";
  for (const std::string& head : table[0]) text += "<th>" + escaped(head) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 1; row < table.size(); ++row) {
    const std::string name = escaped(table[row][0]);
    const bool isScene = std::ranges::find(scenes, table[row][0]) != scenes.end();
    text += "<tr><th scope=\"row\">" +
            (isScene ? "<a href=\"" + name + "/report.html\">" + name + "</a>" : name) + "</th>";
    for (std::size_t k = 1; k < table[row].size(); ++k)
      text += "<td class=\"n\">" + escaped(table[row][k]) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" + latexPart(latexTable(table));
}

/// A BD-rate in a plot: of a scene, or the mean of them with its interval.
struct DeltaMark {
  std::size_t row = 0;
  std::size_t group = 0;
  double rate = 0;
  Interval interval;
};

/// BD-rates on one axis: a row for each name, a kind of mark for each group.
struct DeltaPlot {
  std::string title;  ///< of the axis
  std::vector<std::string> rows;
  std::vector<std::string> groups;
  std::vector<DeltaMark> marks;
};

std::string svgOf(const DeltaPlot& plot, double width) {
  constexpr double right = 12, top = 10, rowHeight = 22, below = 46, groupHeight = 18;
  double left = 40;
  for (const std::string& row : plot.rows) left = std::max(left, textWidth(row) + 14);
  left = std::min(left, 0.4 * width);
  double low = 0, high = 0;
  for (const DeltaMark& mark : plot.marks)
    for (const double value : {mark.rate, mark.interval.low, mark.interval.high}) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  const double margin = 0.05 * std::max(high - low, 1.0);
  const Axis across{low - margin, high + margin, left, width - right};
  const double bottom = top + rowHeight * double(plot.rows.size());
  const double names = plot.groups.size() > 1 ? groupHeight * double(plot.groups.size()) : 0;
  std::string svg = svgStart(styleFor(width), width, numberText(bottom + below + names),
                             "BD-rate of each scene and their mean");
  for (const Tick& tick : linearTicks(across, 6)) {
    if (tick.text.empty()) continue;
    const double x = across.at(tick.value);
    svg +=
        svgLine(x, top, x, bottom, "class=\"grid\"") + svgText(x, bottom + 16, "middle", tick.text);
  }
  svg += svgLine(across.at(0), top, across.at(0), bottom, "class=\"frame\"") +
         svgText((left + width - right) / 2, bottom + 36, "middle", plot.title);
  const auto middleOf = [&](std::size_t row) { return top + rowHeight * (double(row) + 0.5); };
  for (std::size_t row = 0; row < plot.rows.size(); ++row)
    svg += svgText(left - 8, middleOf(row) + 4, "end", shortName(plot.rows[row], left - 10));
  for (const auto& [row, group, rate, interval] : plot.marks) {
    if (!std::isfinite(rate)) continue;
    const double y = middleOf(row) + 3 * double(group % 3) - 3;
    svg += svgGroup(group);
    if (std::isfinite(interval.low))
      svg += svgLine(across.at(interval.low), y, across.at(interval.high), y, "class=\"interval\"");
    svg += svgMark(group, across.at(rate), y, 4, "",
                   "<title>" + escaped(plot.rows[row] + ", " + plot.groups[group] + ": ") +
                       percent(rate) + "</title>") +
           "</g>";
  }
  for (std::size_t group = 0; names > 0 && group < plot.groups.size(); ++group) {
    const double y = bottom + below + groupHeight * double(group) + 12;
    svg += svgGroup(group) + svgMark(group, left + 6, y - 4, 4, "", "") + "</g>" +
           svgText(left + 18, y, "start", shortName(plot.groups[group], width - left - 18));
  }
  return svg + "</svg>";
}

/// The BD-rates of the scenes, and below them the means.
Figure deltaFigure(const CampaignResult& result) {
  const std::vector<const BdOverScenes*> main = mainComparisons(result);
  DeltaPlot plot{"BD-rate in % against " + result.groups.front(), result.scenes, {}, {}};
  plot.rows.emplace_back(meanRow);
  for (const BdOverScenes* one : main) plot.groups.push_back(one->group);
  Table csv{{"scene", "group", "bd_rate_percent", "low", "high"}};
  for (std::size_t row = 0; row < plot.rows.size(); ++row)
    for (std::size_t group = 0; group < main.size(); ++group) {
      const bool isMean = row == result.scenes.size();
      const DeltaMark mark{
          row, group, isMean ? main[group]->rate : main[group]->ofScenes[row],
          isMean ? main[group]->rateInterval : Interval{unknownFigure, unknownFigure}};
      csv.push_back({plot.rows[row], plot.groups[group], numberCell(mark.rate),
                     numberCell(mark.interval.low), numberCell(mark.interval.high)});
      plot.marks.push_back(mark);
    }
  return {"bd_rates", "BD-rate of each scene", "",
          [plot](double width) { return svgOf(plot, width); }, csvText(csv)};
}

std::string testsOfSigns(const CampaignResult& result) {
  std::string text;
  for (const BdOverScenes* one : mainComparisons(result)) {
    if (one->scenes == 0) continue;
    text += "<p>" + escaped(one->group) + " needs less than " + escaped(one->anchor) + " in " +
            std::to_string(one->better) + " of " + std::to_string(one->scenes) +
            " scenes: sign test p = " + rounded(one->signTest, 3) +
            ", Wilcoxon's signed-rank test p = " + rounded(one->signedRankTest, 3) + ".</p>\n";
  }
  return text;
}

constexpr const char* definitions =
    R"html(<h2>How to read the figures</h2>
<dl>
<dt>BD-rate</dt><dd>Bits that a group needs in addition to the first one for the same mean PSNR over the pixels
seen, by Bjøntegaard's method; below 0 it needs less. Other qualities and pairs are in bd.csv.</dd>
<dt>Mean of scenes</dt><dd>Each scene weighs alike, however many states it has.</dd>
<dt>Intervals</dt><dd>95 % percentile bootstrap of two levels, 1000 draws: scenes are drawn, and then states of each
scene that is drawn. They tell how a mean would vary with other scenes and states of the same kind.</dd>
<dt>Tests of signs</dt><dd>Two-sided, exact, over the BD-rates of the scenes: how probable it is that scenes differ
as much in one direction by chance. With fewer than six scenes neither can be below 0.05.</dd>
</dl>
)html";

}  // namespace

void writeCampaignPage(const CampaignResult& result, const std::string& title,
                       const fs::path& output) {
  const bool areCompared = !mainComparisons(result).empty();
  std::string text = "<h1>" + escaped("Campaign: " + title) + "</h1>\n";
  std::string tex;
  if (areCompared) {
    const Table deltas = deltaTable(result);
    const Figure figure = deltaFigure(result);
    writeFigures(output, {figure});
    text += "<h2>BD-rates</h2>\n" + htmlOf(deltas, result.scenes) + testsOfSigns(result) +
            figureTag(figure);
    tex += latexTable(deltas) + "\n";
  }
  const Table tests = testTable(result);
  tex += latexTable(tests);
  text += "<h2>Means over the scenes</h2>\n" + htmlOf(tests, {});
  if (!areCompared) {
    text += "<h2>Scenes</h2>\n<ul>\n";
    for (const std::string& scene : result.scenes)
      text +=
          "<li><a href=\"" + escaped(scene) + "/report.html\">" + escaped(scene) + "</a></li>\n";
    text += "</ul>\n";
  }
  if (!result.missing.empty()) {
    text += "<h2>Missing</h2>\n<table id=\"missing\"><tbody>\n";
    for (const std::string& line : result.missing)
      text += "<tr><td>" + escaped(line) + "</td></tr>\n";
    text += "</tbody></table>\n";
  }
  makeFolder(output / "plots");
  writeTextFile(output / "plots" / "campaign.tex", tex);
  writeTextFile(output / "campaign.html",
                pageOf("Hogelscope campaign: " + title, text + definitions));
}

std::string campaignText(const CampaignResult& result) {
  std::string text;
  for (const BdOverScenes* one : mainComparisons(result))
    text += one->group + " against " + one->anchor + ", " + one->quality.name +
            (one->isWeighted ? ", weighted: " : ": ") + "BD-rate " +
            withRange(one->rate, one->rateInterval, 2, " %") + " over " +
            std::to_string(one->scenes) + " scene" + (one->scenes == 1 ? "" : "s") + ", less in " +
            std::to_string(one->better) + "\n";
  for (const TestOverScenes& test : result.over.tests)
    text += printable(test.test) + ": mean PSNR " +
            withRange(test.means[meanPsnrSeen], test.intervals[meanPsnrSeen], 2,
                      std::isfinite(test.means[meanPsnrSeen]) ? " dB" : "") +
            " over " + std::to_string(test.scenes) + " scene" + (test.scenes == 1 ? "" : "s") +
            "\n";
  return text;
}

}  // namespace hogelscope
