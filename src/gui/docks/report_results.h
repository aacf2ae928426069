// SPDX-License-Identifier: BSD-3-Clause
// The tables of a report: its tests, and the states of one test with what explains their figures.
#pragma once

#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <vector>

#include "core/base/row_filter.h"
#include "core/metrics/panel_error_figures.h"
#include "report/page/window_plots.h"
#include "report/report_request.h"

namespace hogelscope {

/// A report that is being made, was made, or was read from its folder.
struct ReportData {
  Session session;      ///< its states are those of the rows
  std::string folder;   ///< of its files
  bool isRead = false;  ///< from its folder; the session's states may be others
  MetricSet metrics{};
  std::vector<std::string> tests{};         ///< files
  std::vector<PlottedTest> plotted{};       ///< of each test
  std::vector<ReportRow> rows{};            ///< in ReportOrder
  std::vector<TestSummary> summaries{};     ///< empty until the report is finished
  std::vector<PanelErrorFigures> panels{};  ///< of each test; empty if unknown

  /// Adds rows that say that nothing is compared yet, and the names of the tests.
  void begin();
  [[nodiscard]] ReportOrder order() const { return {tests.size()}; }
  /// Returns the PSNR over what is seen; NaN for rows with a problem.
  [[nodiscard]] double psnr(std::size_t row) const;
  /// Returns the state with the least or the largest PSNR of a test.
  [[nodiscard]] std::optional<std::size_t> extreme(std::size_t test, bool isBest) const;
};

/// Returns the files' names without folders, with as much of the path as makes them differ.
QStringList shortNames(const std::vector<std::string>& files);

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

 private:
  Axis m_range;  ///< of the bars, dB
  double m_usualSigma = 0;
  double m_usualWindow = 0;
};

/// Sorts the states by numbers, and filters them by a line of text.
class StateFilter : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void setText(const QString& text);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  RowFilter m_filter;
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
  explicit CopyTable(const QString& name);
  void copy(bool isAll);

 protected:
  bool event(QEvent* event) override;
};

}  // namespace hogelscope
