// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/row_filter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/base/text.h"

namespace hogelscope {

namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return std::string(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
}

/// Returns the index of the column, or their number if there is none.
std::size_t columnOf(const std::string& name, const std::vector<std::string>& columns) {
  const std::string begin = name == "sigma" ? "σ" : name;
  const auto found = std::ranges::find_if(columns, [&](const std::string& column) {
    return !begin.empty() && column.starts_with(begin);
  });
  return std::size_t(found - columns.begin());
}

}  // namespace

RowFilter::RowFilter(const std::string& text, const std::vector<std::string>& columns) {
  std::istringstream parts(text);
  for (std::string line; std::getline(parts, line, ',');) {
    const std::string part = trimmed(line);
    std::optional<Condition> condition;
    for (const std::string_view sign : {"<=", ">=", "≤", "≥", "<", ">", "="}) {
      const std::size_t at = part.find(sign);
      if (condition || at == std::string::npos) continue;
      const std::optional<double> number = numberOf(trimmed(part.substr(at + sign.size())));
      const std::size_t column = columnOf(trimmed(part.substr(0, at)), columns);
      if (number && column < columns.size()) condition = {column, std::string(sign), *number};
    }
    const auto alone = std::ranges::find(columns, part);
    if (!condition && alone != columns.end())
      condition = {std::size_t(alone - columns.begin()), {}, 0};
    if (condition)
      m_conditions.push_back(*condition);
    else if (!part.empty())
      m_texts.push_back(part);
  }
}

bool RowFilter::Condition::holds(double value) const {
  if (std::isnan(value)) return false;
  if (comparison == "<") return value < number;
  if (comparison == ">") return value > number;
  if (comparison == "≤" || comparison == "<=") return value <= number;
  if (comparison == "≥" || comparison == ">=") return value >= number;
  return comparison.empty() ? value != 0 : value == number;
}

bool RowFilter::accepts(const std::string& name,
                        const std::function<double(std::size_t k)>& value) const {
  const auto isIn = [&](const std::string& text) { return name.find(text) != std::string::npos; };
  return std::ranges::all_of(m_texts, isIn) &&
         std::ranges::all_of(m_conditions, [&](const Condition& condition) {
           return condition.holds(value(condition.column));
         });
}

}  // namespace hogelscope
