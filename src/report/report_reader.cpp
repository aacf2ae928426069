// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_reader.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The lines of a file of the report, whose cells have the names of its first line.
class StoredTable {
 public:
  explicit StoredTable(const fs::path& file) : m_file(file), m_lines(csvRows(readTextFile(file))) {
    if (m_lines.empty()) m_lines.push_back({});
  }
  [[nodiscard]] std::size_t lines() const { return m_lines.size() - 1; }
  [[nodiscard]] std::string cell(std::size_t line, std::string_view name) const {
    const auto at = std::size_t(std::ranges::find(m_lines[0], name) - m_lines[0].begin());
    return at < m_lines[line + 1].size() ? m_lines[line + 1][at] : std::string();
  }
  [[nodiscard]] double number(std::size_t line, std::string_view name) const {
    return numberOf(cell(line, name)).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(m_file.string(), "is no table of a report", why);
  }

 private:
  fs::path m_file;
  Table m_lines;
};

/// Adds the figures of a table, which has a line for each row.
void addFigures(std::vector<ReportRow>& rows, const StoredTable& table, const MetricSet& metrics) {
  if (table.lines() != rows.size()) table.refuse("report.csv has another number of lines");
  for (std::size_t line = 0; line < rows.size(); ++line)
    for (std::size_t k = 0; k < metrics.columns().size(); ++k)
      if (const double value = table.number(line, metrics.columns()[k].name); value == value)
        rows[line].values[k] = value;
}

}  // namespace

StoredReport readReport(const fs::path& folder, const MetricSet& metrics) {
  const auto has = [&](const char* name) { return fs::is_regular_file(folder / name); };
  if (!has("report.csv")) throw InputError(folder.string(), "is no report", "it has no report.csv");
  const StoredTable table(folder / "report.csv");
  StoredReport report;
  for (std::size_t line = 0; line < table.lines(); ++line)
    report.rows.push_back(
        {table.cell(line, "state"),
         table.cell(line, "test"),
         metrics.noValues(),
         {table.number(line, "eye_x"), table.number(line, "eye_y"), table.number(line, "eye_z")}});
  for (std::size_t line = 0; line < table.lines(); ++line)
    if (const auto frame = numberOf(table.cell(line, "frame")))
      report.rows[line].frame = int(*frame);
  const std::vector<std::string> tests = testsOf(report.rows);
  for (std::size_t k = 0; k < report.rows.size(); ++k)
    if (report.rows[k].test.empty() || report.rows[k].test != tests[k % tests.size()] ||
        report.rows[k].state != report.rows[k - k % tests.size()].state)
      table.refuse("it has not every test for every state");
  if (tests.empty() || report.rows.size() % tests.size() != 0)
    table.refuse("it has not every test for every state");
  addFigures(report.rows, table, metrics);
  if (has("metrics.csv")) {
    const StoredTable more(folder / "metrics.csv");
    addFigures(report.rows, more, metrics);
    for (std::size_t line = 0; line < report.rows.size(); ++line) {
      report.rows[line].weight = more.number(line, "weight");
      report.rows[line].problem = more.cell(line, "problem");
    }
  }
  if (!has("summary.csv")) return report;
  const StoredTable summary(folder / "summary.csv");
  for (std::size_t line = 0; line < summary.lines(); ++line)
    if (summary.cell(line, "figure") == "rate_bpp")
      report.rates.push_back({summary.cell(line, "test"), summary.number(line, "value")});
  return report;
}

}  // namespace hogelscope
