// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/row_filter.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

/// Returns the index of the column, or their number if there is none.
std::size_t columnOf(QString name, const QStringList& columns) {
  if (name.compare("sigma", Qt::CaseInsensitive) == 0) name = "σ";
  const auto found = std::ranges::find_if(columns, [&](const QString& column) {
    return !name.isEmpty() && column.startsWith(name, Qt::CaseInsensitive);
  });
  return std::size_t(found - columns.begin());
}

}  // namespace

RowFilter::RowFilter(const QString& text, const QStringList& columns) {
  static const QRegularExpression form(R"(^([^<>=≤≥]+)(<=|>=|[<>=≤≥])\s*([-\d.]+)$)");
  for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
    const QString trimmed = part.trimmed();
    const QRegularExpressionMatch match = form.match(trimmed);
    const std::size_t column =
        columnOf(match.hasMatch() ? match.captured(1).trimmed() : trimmed, columns);
    bool isNumber = false;
    const double number = match.captured(3).toDouble(&isNumber);
    if (column < std::size_t(columns.size()) && isNumber)
      m_conditions.push_back({column, match.captured(2), number});
    else if (columns.contains(trimmed, Qt::CaseInsensitive))
      m_conditions.push_back({column, {}, 0});
    else if (!trimmed.isEmpty())
      m_texts << trimmed;
  }
}

bool RowFilter::Condition::holds(double value) const {
  if (std::isnan(value)) return false;
  if (comparison == "<") return value < number;
  if (comparison == ">") return value > number;
  if (comparison == "≤" || comparison == "<=") return value <= number;
  if (comparison == "≥" || comparison == ">=") return value >= number;
  return comparison.isEmpty() ? value != 0 : value == number;
}

bool RowFilter::accepts(const QString& name,
                        const std::function<double(std::size_t k)>& value) const {
  return std::ranges::all_of(
             m_texts,
             [&](const QString& text) { return name.contains(text, Qt::CaseInsensitive); }) &&
         std::ranges::all_of(m_conditions, [&](const Condition& condition) {
           return condition.holds(value(condition.column));
         });
}

}  // namespace hogelscope
