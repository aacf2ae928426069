// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_table.h"

#include <cmath>
#include <limits>

namespace hogelscope {

ReportTable::ReportTable(QObject* parent) : QAbstractTableModel(parent) {
  begin(0);
}

void ReportTable::begin(std::size_t rows, const MetricSet& metrics) {
  beginResetModel();
  m_metrics = metrics;
  m_columns.clear();
  for (std::size_t k = 0; k < m_metrics.columns().size(); ++k)
    if (m_metrics.columns()[k].where == MetricColumn::Where::window) m_columns.push_back(k);
  m_rows.assign(rows, std::nullopt);
  endResetModel();
}

void ReportTable::set(std::size_t index, const ReportRow& row) {
  if (index >= m_rows.size()) return;
  m_rows[index] = row;
  Q_EMIT headerDataChanged(Qt::Vertical, int(index), int(index));
  Q_EMIT dataChanged(this->index(int(index), 0), this->index(int(index), columnCount() - 1));
}

int ReportTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_rows.size());
}

int ReportTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : 1 + int(m_columns.size());
}

QString ReportTable::textOf(const ReportRow& row, int column) const {
  if (column == test) return QString::fromStdString(row.test);
  if (column == test + 1 && !row.problem.empty()) return QString::fromStdString(row.problem);
  return QString::fromStdString(tableText(metric(column), value(row, column)));
}

QVariant ReportTable::data(const QModelIndex& index, int role) const {
  const std::optional<ReportRow>& row = m_rows[std::size_t(index.row())];
  const bool isText = index.column() == test;
  if (role == Qt::TextAlignmentRole && !isText) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (!row) return {};
  if (role == Qt::ToolTipRole) return QString::fromStdString(row->problem);
  if (role == Qt::DisplayRole || (role == sortRole && isText)) return textOf(*row, index.column());
  if (role != sortRole) return {};
  const double number = value(*row, index.column());
  return std::isnan(number) ? -std::numeric_limits<double>::infinity() : number;  // problems first
}

QVariant ReportTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return rowHeader(section, role);
  if (section < 0 || section >= columnCount()) return {};
  if (section == test) {
    if (role == Qt::DisplayRole) return tr("Test");
    if (role == Qt::ToolTipRole) return tr("The test light field");
    return {};
  }
  const MetricColumn& column = metric(section);
  const std::string unit = column.unit.empty() ? "" : ", " + column.unit;
  if (role == Qt::DisplayRole) return QString::fromStdString(column.title + unit);
  if (role == Qt::ToolTipRole) return QString::fromStdString(column.help);
  return {};
}

QVariant ReportTable::rowHeader(int section, int role) const {
  if (section < 0 || section >= rowCount() || !m_rows[std::size_t(section)]) return {};
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  return QString::fromStdString(m_rows[std::size_t(section)]->state);
}

}  // namespace hogelscope
