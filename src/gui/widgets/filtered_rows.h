// SPDX-License-Identifier: BSD-3-Clause
// The rows of a list or table that a filter lets through.
#pragma once

#include <QSortFilterProxyModel>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/row_filter.h"

namespace hogelscope {

/// Returns a filter for which upper and lower case are the same.
inline RowFilter rowFilter(const QString& text, const QStringList& columns) {
  std::vector<std::string> names;
  for (const QString& column : columns) names.push_back(column.toLower().toStdString());
  return {text.toLower().toStdString(), names};
}

class FilteredRows : public QSortFilterProxyModel {
 public:
  /// `value` returns the value of a row of `rows`, as for RowFilter. A row's text is its name.
  FilteredRows(QAbstractItemModel* rows, std::function<double(int row, std::size_t k)> value)
      : QSortFilterProxyModel(rows), m_value(std::move(value)) {
    setSourceModel(rows);
  }
  /// Sets a filter made by rowFilter().
  void setFilter(const RowFilter& filter) {
    m_filter = filter;
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const QString name = sourceModel()->index(row, 0, parent).data().toString();
    return m_filter.accepts(name.toLower().toStdString(),
                            [&](std::size_t k) { return m_value(row, k); });
  }

 private:
  std::function<double(int row, std::size_t k)> m_value;
  RowFilter m_filter;
};

}  // namespace hogelscope
