// SPDX-License-Identifier: BSD-3-Clause
// Filter of the rows of a table by a line of text.
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>
#include <functional>
#include <utility>
#include <vector>

namespace hogelscope {

/// The parts of a line such as "Fig, lens, σ < 0.5, angle > 20". A row passes if all parts hold:
/// a column with < > = ≤ ≥ <= >= and a number compares; a column alone holds if its value is not 0;
/// any other text must be a part of the row's name.
class RowFilter {
 public:
  RowFilter() = default;
  /// `columns` are the names of the columns with numbers. A beginning of a name stands for the
  /// first column with it, and "sigma" for "σ"; upper and lower case are the same.
  RowFilter(const QString& text, const QStringList& columns);

  /// `value` returns a row's value of columns[k]; NaN, which is in no condition, if it has none.
  [[nodiscard]] bool accepts(const QString& name,
                             const std::function<double(std::size_t k)>& value) const;

 private:
  struct Condition {
    std::size_t column = 0;
    QString comparison;  ///< "": not 0
    double number = 0;
    [[nodiscard]] bool holds(double value) const;
  };
  std::vector<Condition> m_conditions;
  QStringList m_texts;
};

/// The rows of a list or table that a filter lets through.
class FilteredRows : public QSortFilterProxyModel {
 public:
  /// `value` returns the value of a row of `rows`, as for RowFilter. A row's text is its name.
  FilteredRows(QAbstractItemModel* rows, std::function<double(int row, std::size_t k)> value)
      : QSortFilterProxyModel(rows), m_value(std::move(value)) {
    setSourceModel(rows);
  }
  void setFilter(const RowFilter& filter) {
    m_filter = filter;
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    return m_filter.accepts(sourceModel()->index(row, 0, parent).data().toString(),
                            [&](std::size_t k) { return m_value(row, k); });
  }

 private:
  std::function<double(int row, std::size_t k)> m_value;
  RowFilter m_filter;
};

}  // namespace hogelscope
