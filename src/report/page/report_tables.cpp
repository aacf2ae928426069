// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_tables.h"

#include <algorithm>

#include "core/base/text.h"
#include "page/html.h"

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

}  // namespace hogelscope
