// SPDX-License-Identifier: BSD-3-Clause
// Filter of the rows of a table by a line of text.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hogelscope {

/// The parts of a line such as "fig, lens, σ < 0.5, angle > 20". A row passes if all parts hold:
/// a column with < > = ≤ ≥ <= >= and a number compares; a column alone holds if its value is not 0;
/// any other text must be a part of the row's name. All texts are compared as they are: callers for
/// whom upper and lower case are the same pass lower case.
class RowFilter {
 public:
  RowFilter() = default;
  /// `columns` are the names of the columns with numbers. A beginning of a name stands for the
  /// first column with it, and "sigma" for "σ".
  RowFilter(const std::string& text, const std::vector<std::string>& columns);

  /// `value` returns a row's value of columns[k]; NaN, which is in no condition, if it has none.
  [[nodiscard]] bool accepts(const std::string& name,
                             const std::function<double(std::size_t k)>& value) const;

 private:
  struct Condition {
    std::size_t column = 0;
    std::string comparison;  ///< "": not 0
    double number = 0;
    [[nodiscard]] bool holds(double value) const;
  };
  std::vector<Condition> m_conditions;
  std::vector<std::string> m_texts;
};

}  // namespace hogelscope
