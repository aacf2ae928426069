// SPDX-License-Identifier: BSD-3-Clause
// The tables of a report: its tests, and the states of one test with what explains their figures.
#pragma once

#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTableView>

#include "gui/widgets/filtered_rows.h"
#include "report/report_data.h"

namespace hogelscope {

/// The roles of both tables' items: numbers for sorting and filtering (problems are -∞), and bars.
enum ReportRole { sortRole = Qt::UserRole, barRole };

/// The table of tests.
class TestTable : public QStandardItemModel {
 public:
  enum Column { name, rate, psnr, bar, ssim, worst, best };
  using QStandardItemModel::QStandardItemModel;
  void fill(const ReportData& data);
  /// Updates the row of a test.
  void fill(const ReportData& data, std::size_t test);
};

/// The table of the states of a test; columns of plugins' metrics follow those named here.
class StateTable : public QStandardItemModel {
 public:
  enum Column { name, psnr, ssim, seen, sigma, window, lens, distance, angle, plugins };
  using QStandardItemModel::QStandardItemModel;
  void fill(const ReportData& data, std::size_t test);
  /// Updates the row of a state.
  void fill(const ReportData& data, std::size_t test, std::size_t state);
  /// Returns the filter that a line of text makes of the columns with numbers.
  [[nodiscard]] RowFilter filterOf(const QString& text) const;
  /// Returns the number of a row in column k + 1; NaN for a problem.
  [[nodiscard]] double numberOf(int row, std::size_t k) const;

 private:
  Axis m_range;  ///< of the bars, dB
  double m_usualSigma = 0;
  double m_usualWindow = 0;
};

/// Paints an item's bar: the share of a state's PSNR, or {worst, best, low, high, mean} of a test.
class BarDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// A table whose rows can be copied as CSV by Ctrl+C: the selected ones, or all.
class CopyTable : public QTableView {
  Q_OBJECT

 public:
  explicit CopyTable(QWidget* parent);
  void copy(bool isAll);

 protected:
  bool event(QEvent* event) override;
};

}  // namespace hogelscope
