// SPDX-License-Identifier: BSD-3-Clause
// A report's rows as a table.
#include "gui/docks/report_table.h"

#include <cmath>
#include <limits>

namespace hogelscope {

namespace {

double number(const ReportRow& row, int column) {
  switch (column) {
    case ReportTable::psnrColumn:
      return psnr(row.metrics.mse);
    case ReportTable::psnrSeenColumn:
      return psnr(row.metrics.mseSeen);
    case ReportTable::ssimColumn:
      return row.metrics.ssim;
    default:
      return 100 * row.metrics.seen;
  }
}

QString shown(const ReportRow& row, int column) {
  if (column == ReportTable::test) return QString::fromStdString(row.test);
  if (column == ReportTable::psnrColumn && !row.problem.empty())
    return QString::fromStdString(row.problem);
  const double value = number(row, column);
  if (std::isinf(value)) return ReportTable::tr("identical");
  if (std::isnan(value)) return QStringLiteral("–");
  return QString::number(value, 'f',
                         column == ReportTable::ssimColumn   ? 4
                         : column == ReportTable::seenColumn ? 1
                                                             : 2);
}

}  // namespace

void ReportTable::begin(std::size_t rows) {
  beginResetModel();
  m_rows.assign(rows, std::nullopt);
  endResetModel();
}

void ReportTable::set(std::size_t index, const ReportRow& row) {
  if (index >= m_rows.size()) return;
  m_rows[index] = row;
  Q_EMIT headerDataChanged(Qt::Vertical, int(index), int(index));
  Q_EMIT dataChanged(this->index(int(index), 0), this->index(int(index), columns - 1));
}

int ReportTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_rows.size());
}

int ReportTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(columns);
}

QVariant ReportTable::data(const QModelIndex& index, int role) const {
  const std::optional<ReportRow>& row = m_rows[std::size_t(index.row())];
  const bool isText = index.column() == test;
  if (role == Qt::TextAlignmentRole && !isText) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (!row) return {};
  if (role == Qt::ToolTipRole) return QString::fromStdString(row->problem);
  if (role == Qt::DisplayRole || (role == sortRole && isText)) return shown(*row, index.column());
  if (role != sortRole) return {};
  const double value = number(*row, index.column());
  return std::isnan(value) ? -std::numeric_limits<double>::infinity() : value;  // problems first
}

QVariant ReportTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return rowHeader(section, role);
  if (section < 0 || section >= columns) return {};
  const char* const titles[] = {QT_TR_NOOP("Test"), QT_TR_NOOP("PSNR, dB"),
                                QT_TR_NOOP("PSNR seen, dB"), QT_TR_NOOP("SSIM"),
                                QT_TR_NOOP("Seen, %")};
  const char* const seenHelp = QT_TR_NOOP(
      "Share of the picture's pixels that see the display in both pictures; how much of the panel "
      "lights the eye, under the 3-D scene, is another figure");
  const char* const helps[] = {
      QT_TR_NOOP("The test light field"),
      QT_TR_NOOP("Over the whole picture; higher is closer to the reference"),
      QT_TR_NOOP("Over the pixels that see the display in both pictures"),
      QT_TR_NOOP("Structural similarity of the luma, 1 for identical pictures"), seenHelp};
  if (role == Qt::DisplayRole) return tr(titles[section]);
  if (role == Qt::ToolTipRole) return tr(helps[section]);
  return {};
}

QVariant ReportTable::rowHeader(int section, int role) const {
  if (section < 0 || section >= rowCount() || !m_rows[std::size_t(section)]) return {};
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  return QString::fromStdString(m_rows[std::size_t(section)]->state);
}

}  // namespace hogelscope
