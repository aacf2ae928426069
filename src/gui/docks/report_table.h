// SPDX-License-Identifier: BSD-3-Clause
// Table model of a report's rows, filled while the report is generated. The row headers are states.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/metrics/report_rows.h"

namespace hogelscope {

class ReportTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// The index of the first column; the metrics' columns follow.
  static constexpr int test = 0;
  /// The role for sorting a column; numbers sort as numbers.
  static constexpr int sortRole = Qt::UserRole;

  explicit ReportTable(QObject* parent);

  /// Resets the table to `rows` empty rows with the columns of `metrics`.
  void begin(std::size_t rows, const MetricSet& metrics = MetricSet());
  void set(std::size_t index, const ReportRow& row);
  [[nodiscard]] const std::optional<ReportRow>& row(std::size_t index) const {
    return m_rows[index];
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  [[nodiscard]] QVariant rowHeader(int section, int role) const;

  [[nodiscard]] QString textOf(const ReportRow& row, int column) const;
  [[nodiscard]] const MetricColumn& metric(int column) const {
    return m_metrics.columns()[m_columns[std::size_t(column) - 1]];
  }
  [[nodiscard]] double value(const ReportRow& row, int column) const {
    return row.values[m_columns[std::size_t(column) - 1]];
  }

  MetricSet m_metrics;
  std::vector<std::size_t> m_columns;  ///< indices of the metrics that the table shows
  std::vector<std::optional<ReportRow>> m_rows;
};

}  // namespace hogelscope
