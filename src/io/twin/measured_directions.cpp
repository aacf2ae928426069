// SPDX-License-Identifier: BSD-3-Clause
#include "io/twin/measured_directions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

class MeasuredDirectionsReader {
 public:
  explicit MeasuredDirectionsReader(const std::array<int, 2>& directions) {
    m_table.size = directions;
    m_lineOf.resize(std::size_t(directions[0]) * std::size_t(directions[1]));
  }

  /// Takes the next line: the first one that is not empty names the columns.
  void read(std::string_view line) {
    ++m_line;
    constexpr std::size_t longest = 4096;
    if (line.size() > longest) refuse("is longer than " + std::to_string(longest) + " bytes");
    if (trimmed(line).empty()) return;
    std::vector<std::string> cells = csvRows(line).front();
    for (std::string& cell : cells) cell = trimmed(cell);
    if (m_columns == 0) return findColumns(cells);
    if (cells.size() != m_columns)
      refuse("has " + std::to_string(cells.size()) + " cells for " + std::to_string(m_columns) +
             " columns");
    const int u = directionIn(cells, 0);
    const int v = directionIn(cells, 1);
    std::size_t& own = m_lineOf[m_table.at(u, v)];
    if (own != 0)
      refuse("has direction (" + std::to_string(u) + ", " + std::to_string(v) + "), which line " +
             std::to_string(own) + " has too");
    own = m_line;
    add(cells, m_table.at(u, v));
  }

  MeasuredDirections result() {
    if (m_columns == 0) throw InputError("", "is empty: it has to name its columns");
    for (const std::size_t line : m_lineOf) m_table.isGiven.push_back(line != 0);
    for (std::size_t k = firstLight; k < m_at.size(); ++k) {
      std::vector<double>& light = m_table.values[k - 2];
      const double largest = *std::ranges::max_element(light);
      if (!(largest > 0))
        throw InputError(columns[m_names[k]], "has no value above 0, which would be the gain 1");
      for (double& value : light) value /= largest;
    }
    return std::move(m_table);
  }

 private:
  static constexpr std::array<const char*, 8> columns{"u", "v", "x", "y",
                                                      "r", "g", "b", "intensity"};
  static constexpr std::size_t firstLight = 4;  ///< of the columns
  static constexpr std::size_t intensity = 7;

  static std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
  }

  /// Formats a cell for an error line, short.
  static std::string quoted(const std::string& cell) {
    constexpr std::size_t longest = 40;
    return "\"" + cell.substr(0, longest) + (cell.size() > longest ? "…\"" : "\"");
  }

  void findColumns(const std::vector<std::string>& names) {
    m_columns = names.size();
    for (const std::string& name : names) {
      if (std::ranges::find(columns, name) == columns.end())
        refuse("column " + quoted(name) + " is not one of u, v, x, y, r, g, b, intensity");
      if (std::ranges::count(names, name) > 1) refuse("has column " + quoted(name) + " twice");
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto found = std::ranges::find(names, columns[k]);
      if (found == names.end()) continue;
      m_names.push_back(k);
      m_at.push_back(std::size_t(found - names.begin()));
    }
    const std::size_t required = std::size_t(
        std::ranges::count_if(m_names, [](std::size_t name) { return name < firstLight; }));
    if (required < firstLight) refuse("has to name the columns u, v, x and y");
    const std::size_t lights = m_names.size() - firstLight;
    const bool hasIntensity = m_names.back() == intensity;
    if (lights != (hasIntensity ? 1U : 3U) && lights != 0)
      refuse("has to name all of r, g and b, or intensity alone, or none of them");
    m_table.values.assign(m_at.size() - 2, std::vector<double>(m_lineOf.size()));
  }

  void add(const std::vector<std::string>& cells, std::size_t direction) {
    constexpr double steepest = 1000;  // 3 minutes of arc from the panel's plane
    constexpr double brightest = 1e12;
    for (std::size_t k = 2; k < m_at.size(); ++k) {
      const bool isLight = k >= firstLight;
      m_table.values[k - 2][direction] =
          numberIn(cells, k, isLight ? 0 : -steepest, isLight ? brightest : steepest);
    }
  }

  [[nodiscard]] int directionIn(const std::vector<std::string>& cells, std::size_t axis) const {
    const std::string& cell = cells[m_at[axis]];
    const int last = m_table.size[axis] - 1;
    const std::optional<double> value = number(cells, axis);
    if (!value || !(*value >= 0 && *value <= last) || std::floor(*value) != *value)
      refuse(std::string(columns[axis]) + " " + quoted(cell) + " is not a whole number from 0 to " +
             std::to_string(last));
    return int(*value);
  }

  [[nodiscard]] double numberIn(const std::vector<std::string>& cells, std::size_t k, double least,
                                double most) const {
    const std::optional<double> value = number(cells, k);
    if (!value || !(*value >= least && *value <= most))
      refuse(std::string(columns[m_names[k]]) + " " + quoted(cells[m_at[k]]) +
             " is not a number from " + numberText(least) + " to " + numberText(most));
    return *value;
  }

  /// Returns the number in a cell, none for anything else.
  [[nodiscard]] std::optional<double> number(const std::vector<std::string>& cells,
                                             std::size_t k) const {
    const std::string& cell = cells[m_at[k]];
    if (cell.empty()) refuse(std::string(columns[m_names[k]]) + " is empty");
    return numberOf(cell);
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError("line " + std::to_string(m_line), why);
  }

  MeasuredDirections m_table;
  std::size_t m_line = 0;
  std::size_t m_columns = 0;
  std::vector<std::size_t> m_names;   ///< those of `columns` that the table has
  std::vector<std::size_t> m_at;      ///< the cells that they are in
  std::vector<std::size_t> m_lineOf;  ///< of each direction; 0 for none
};

}  // namespace

MeasuredDirections parseMeasuredDirections(std::string_view text,
                                           const std::array<int, 2>& directions) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // as spreadsheets begin a file
  MeasuredDirectionsReader reader(directions);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.result();
}

}  // namespace hogelscope
