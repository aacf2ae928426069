// SPDX-License-Identifier: BSD-3-Clause
#include "campaign/campaign_tables.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "campaign/campaign_page.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/metrics/flicker.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/plugins/metric_plugins.h"
#include "page/figure.h"
#include "report/report_reader.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr const char* allScenes = "all scenes";

Table tableIn(const fs::path& file) {
  if (!fs::is_regular_file(file)) return {};
  return csvRows(readTextFile(file));
}

/// Adds the lines of a scene's table, with the scene before them. The columns are those of the
/// first scene that has lines.
void addLines(Table& all, const std::string& scene, Table table) {
  if (table.empty()) return;
  if (all.empty()) {
    all.push_back(table.front());
    all.front().insert(all.front().begin(), "scene");
  }
  for (std::size_t line = 1; line < table.size(); ++line) {
    all.push_back(std::move(table[line]));
    all.back().insert(all.back().begin(), scene);
    all.back().resize(all.front().size());
  }
}

/// Replaces the files of tests by their names.
void nameTests(Table& table, const std::map<std::string, std::string>& names) {
  if (table.empty()) return;
  const auto column = std::size_t(std::ranges::find(table.front(), "test") - table.front().begin());
  for (std::size_t line = 1; line < table.size(); ++line)
    if (column < table[line].size())
      if (const auto name = names.find(table[line][column]); name != names.end())
        table[line][column] = name->second;
}

/// Returns report.csv with the columns of metrics.csv that it does not have.
Table rowsIn(const fs::path& folder) {
  Table rows = tableIn(folder / "report.csv");
  const Table more = tableIn(folder / "metrics.csv");
  if (rows.empty() || more.size() != rows.size()) return rows;
  const std::vector<std::string> own = rows.front();
  for (std::size_t column = 0; column < more.front().size(); ++column) {
    if (std::ranges::find(own, more.front()[column]) != own.end()) continue;
    for (std::size_t line = 0; line < rows.size(); ++line)
      rows[line].push_back(column < more[line].size() ? more[line][column] : "");
  }
  return rows;
}

/// The report of a scene.
struct FoundScene {
  const CampaignScene* scene = nullptr;
  SceneWork work;
  std::map<std::string, std::string> names;  ///< of tests, by their files
  StoredReport report;
};

/// Returns the figures of a scene, by the names of its tests.
SceneFigures figuresOf(const FoundScene& found, const MetricSet& metrics) {
  SceneFigures figures{found.scene->name, {}, found.work.groups};
  const auto nameOf = [&found](const std::string& file) {
    const auto name = found.names.find(file);
    return name == found.names.end() ? file : name->second;
  };
  for (const std::string& file : testsOf(found.report.rows)) {
    TestSummary& test = figures.tests.emplace_back();
    test.test = nameOf(file);
    std::ranges::copy_if(found.report.rows, std::back_inserter(test.rows),
                         [&](const ReportRow& row) { return row.test == file; });
    test.summary = summariseRows(test.rows, metrics);
    test.intervals.assign(2 * metrics.means().size(), {unknownFigure, unknownFigure});
  }
  for (RateGroup& group : figures.groups)
    for (TestRate& test : group.tests) {
      const auto rate = std::ranges::find(found.report.rates, test.test, &TestRate::test);
      if (rate != found.report.rates.end()) test.rate = rate->rate;
      test.test = nameOf(test.test);
    }
  return figures;
}

void addOver(Table& table, const std::vector<TestOverScenes>& tests, const MetricSet& metrics) {
  for (const TestOverScenes& test : tests) {
    table.push_back({allScenes, test.test, "scenes", std::to_string(test.scenes)});
    for (std::size_t k = 0; k < test.means.size(); ++k) {
      const Interval& plain = test.intervals[k];
      const Interval& weighted = test.intervals[test.means.size() + k];
      table.push_back({allScenes, test.test, metrics.means()[k].name, numberText(test.means[k]),
                       numberText(plain.low), numberText(plain.high), numberText(test.weighted[k]),
                       numberText(weighted.low), numberText(weighted.high), "",
                       metrics.means()[k].isSeen ? "seen" : "frame"});
    }
  }
  for (std::vector<std::string>& line : table) line.resize(table.front().size());
}

/// Adds the comparisons over scenes, by the names of the columns of bd.csv.
void addOver(Table& table, const std::vector<BdOverScenes>& comparisons) {
  if (table.empty()) return;
  const std::size_t width = table.front().size();
  for (const char* name : {"scenes", "scenes_better", "sign_test_p", "signed_rank_p"})
    table.front().emplace_back(name);
  for (const BdOverScenes& one : comparisons) {
    std::vector<std::string> line(table.front().size());
    const auto set = [&](std::string_view column, const std::string& text) {
      const auto at = std::ranges::find(table.front(), column);
      if (at != table.front().end()) line[std::size_t(at - table.front().begin())] = text;
    };
    set("scene", allScenes);
    set("anchor", one.anchor);
    set("group", one.group);
    set("quality", one.quality.name);
    set("bd_rate_percent", numberText(one.rate));
    if (one.quality.unit == "dB") set("bd_psnr_db", numberText(one.gain));
    set("over", one.quality.isSeen ? "seen" : "frame");
    set("unit", one.quality.unit);
    set("bd_quality", numberText(one.gain));
    set("means", one.isWeighted ? "weighted" : "plain");
    set("bd_rate_low", numberText(one.rateInterval.low));
    set("bd_rate_high", numberText(one.rateInterval.high));
    set("bd_quality_low", numberText(one.gainInterval.low));
    set("bd_quality_high", numberText(one.gainInterval.high));
    line[width] = std::to_string(one.scenes);
    line[width + 1] = std::to_string(one.better);
    line[width + 2] = numberText(one.signTest);
    line[width + 3] = numberText(one.signedRankTest);
    table.push_back(std::move(line));
  }
  for (std::vector<std::string>& line : table) line.resize(table.front().size());
}

bool hasFrames(const fs::path& folder) {
  const Table table = tableIn(folder / "report.csv");
  return !table.empty() && std::ranges::find(table.front(), "frame") != table.front().end();
}

}  // namespace

MetricSet campaignMetrics(const Campaign& campaign, const fs::path& output) {
  const auto namesOf = [&](const CampaignScene& scene) {
    return campaign.metrics.empty() ? loadSession(scene.session).metrics : campaign.metrics;
  };
  const CampaignScene& first = campaign.scenes.front();
  const std::vector<std::string> names = namesOf(first);
  std::optional<bool> areInTime;
  for (const CampaignScene& scene : campaign.scenes) {
    if (namesOf(scene) != names)
      throw InputError(
          campaign.file, "metrics",
          first.name + " and " + scene.name + " have different ones: list those of all scenes");
    if (!fs::is_regular_file(output / scene.name / "report.csv")) continue;
    const bool isInTime = hasFrames(output / scene.name);
    if (areInTime.value_or(isInTime) != isInTime)
      throw InputError(campaign.file, "scenes",
                       "some have frames and some are stills, which have no common figures: make "
                       "two campaigns");
    areInTime = isInTime;
  }
  std::vector<Metric> others;
  if (areInTime.value_or(false)) others.push_back(flickerMetric());
  return metricsOf(names, std::move(others));
}

std::vector<std::string> tableColumns(const Campaign& campaign, const MetricSet& metrics) {
  const std::vector<MetricMean>& means = metrics.means();
  std::vector<std::string> headlines{"scenes"};
  std::string known = "scenes";
  for (std::size_t k = 0; k < means.size(); ++k) {
    known += ", " + means[k].name;
    if (metrics.isHeadline(k)) headlines.push_back(means[k].name);
  }
  for (const std::string& name : campaign.columns)
    if (name != "scenes" && std::ranges::find(means, name, &MetricMean::name) == means.end())
      throw InputError(campaign.file, "tables.columns", "\"" + name + "\" is none of " + known);
  return campaign.columns.empty() ? headlines : campaign.columns;
}

std::vector<fs::path> campaignFiles(const fs::path& output) {
  std::vector<fs::path> files;
  for (const char* name :
       {"campaign.csv", "summary.csv", "bd.csv", "campaign.html", "plots/campaign.tex"})
    files.push_back(output / name);
  for (const std::string ending : figureEndings)
    files.push_back(output / "plots" / ("bd_rates" + ending));
  return files;
}

CampaignResult writeCampaign(const Campaign& campaign, const fs::path& output) {
  CampaignResult result;
  result.metrics = campaignMetrics(campaign, output);
  result.columns = tableColumns(campaign, result.metrics);
  for (const CampaignTest& test : campaign.tests)
    if (!test.group.empty() && std::ranges::find(result.groups, test.group) == result.groups.end())
      result.groups.push_back(test.group);
  std::vector<SceneFigures> figures;
  Table rows, summary, deltas;
  for (const CampaignScene& scene : campaign.scenes) {
    FoundScene found{&scene, workOf(campaign, scene, output), {}, {}};
    for (const std::string& line : found.work.lines)
      result.missing.push_back(scene.name + ": " + line);
    if (found.work.tests.empty()) continue;
    for (const SceneTest& test : found.work.tests) found.names[test.file] = test.test->name;
    const fs::path folder = output / scene.name;
    found.report = readReport(folder, result.metrics);
    result.scenes.push_back(scene.name);
    figures.push_back(figuresOf(found, result.metrics));
    const auto add = [&](Table& all, Table table) {
      nameTests(table, found.names);
      addLines(all, scene.name, std::move(table));
    };
    add(rows, rowsIn(folder));
    add(summary, tableIn(folder / "summary.csv"));
    add(deltas, tableIn(folder / "bd.csv"));
  }
  if (figures.empty()) throw InputError(campaign.file, "tests", "no scene has any of them");
  result.over = overScenes(figures, result.metrics);
  addOver(summary, result.over.tests, result.metrics);
  addOver(deltas, result.over.comparisons);
  writeTextFile(output / "campaign.csv", csvText(rows));
  writeTextFile(output / "summary.csv", csvText(summary));
  if (!deltas.empty()) writeTextFile(output / "bd.csv", csvText(deltas));
  writeCampaignPage(result, fs::path(campaign.file).stem().string(), output);
  return result;
}

}  // namespace hogelscope
