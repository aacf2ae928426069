// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/report_rows.h"

#include <algorithm>
#include <array>

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

template <class Columns>
std::string csvHeader(const Columns& columns, const MetricSet& metrics) {
  std::string text = "state,test";
  for (const std::size_t k : columns) text += "," + csvCell(metrics.columns()[k].name);
  return text;
}

template <class Columns>
std::string csvStart(const ReportRow& row, const Columns& columns) {
  std::string text = csvCell(row.state) + "," + csvCell(row.test);
  for (const std::size_t k : columns) text += "," + numberText(row.values[k]);
  return text;
}

}  // namespace

std::string reportCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  std::string text = csvHeader(reportColumns, metrics) + ",eye_x,eye_y,eye_z\n";
  for (const ReportRow& row : rows)
    text += csvStart(row, reportColumns) + "," + numberText(row.eye.x) + "," +
            numberText(row.eye.y) + "," + numberText(row.eye.z) + "\n";
  return text;
}

std::string metricsCsv(const std::vector<ReportRow>& rows, const MetricSet& metrics) {
  const std::vector<std::size_t> columns = otherColumns(metrics);
  std::string text = csvHeader(columns, metrics) + ",weight,problem\n";
  for (const ReportRow& row : rows)
    text +=
        csvStart(row, columns) + "," + numberText(row.weight) + "," + csvCell(row.problem) + "\n";
  return text;
}

}  // namespace hogelscope
