// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/report_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text.h"

namespace hogelscope {

namespace {

/// The columns of report.csv. They never change, because users' scripts read them.
constexpr std::array<MetricIndex, 6> reportColumns{mseColumn,      psnrColumn, mseSeenColumn,
                                                   psnrSeenColumn, ssimColumn, seenColumn};

/// Returns the columns missing in report.csv.
std::vector<std::size_t> otherColumns(const MetricSet& metrics) {
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < metrics.columns().size(); ++k)
    if (std::ranges::find(reportColumns, k) == reportColumns.end()) others.push_back(k);
  return others;
}

/// Returns a table of the rows' states, tests and these columns.
template <class Columns>
Table tableOf(const std::vector<ReportRow>& rows, const Columns& columns,
              const MetricSet& metrics) {
  Table table{{"state", "test"}};
  for (const std::size_t k : columns) table[0].push_back(metrics.columns()[k].name);
  for (const ReportRow& row : rows) {
    table.push_back({row.state, row.test});
    for (const std::size_t k : columns) table.back().push_back(numberText(row.values[k]));
  }
  return table;
}

/// Adds the column of the frames, if there are any, and returns the file.
std::string textWithFrames(Table table, const std::vector<ReportRow>& rows) {
  if (rows.empty() || !rows.front().frame) return csvText(table);
  table[0].emplace_back("frame");
  for (std::size_t k = 0; k < rows.size(); ++k)
    table[k + 1].push_back(std::to_string(rows[k].frame.value_or(0)));
  return csvText(table);
}

}  // namespace

std::string viewName(const ReportRow& row) {
  return row.frame ? row.state + ", frame " + std::to_string(*row.frame) : row.state;
}

std::string reportCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  Table table = tableOf(rows, reportColumns, metrics);
  table[0].insert(table[0].end(), {"eye_x", "eye_y", "eye_z"});
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const double place : {rows[k].eye.x, rows[k].eye.y, rows[k].eye.z})
      table[k + 1].push_back(numberText(place));
  return textWithFrames(std::move(table), rows);
}

std::string metricsCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  Table table = tableOf(rows, otherColumns(metrics), metrics);
  table[0].insert(table[0].end(), {"weight", "problem"});
  for (std::size_t k = 0; k < rows.size(); ++k)
    table[k + 1].insert(table[k + 1].end(), {numberText(rows[k].weight), rows[k].problem});
  return textWithFrames(std::move(table), rows);
}

}  // namespace hogelscope
