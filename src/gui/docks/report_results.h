// SPDX-License-Identifier: BSD-3-Clause
// A report's results: the table of its rows and the plots over its views.
#pragma once

#include <QAbstractTableModel>
#include <QPixmap>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/metrics/report_rows.h"
#include "page/plot.h"
#include "report/report_request.h"

class QComboBox;

namespace hogelscope {

class PlotSaver;

/// Table model of a report's rows, filled while the report is generated. The row headers are
/// states.
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

/// A single plot. A click on a point or a row's position emits the row.
class ReportPlotView : public QWidget {
  Q_OBJECT

 public:
  explicit ReportPlotView(QWidget* parent = nullptr);
  void setPlot(Plot plot);
  /// Shows an image in place of the chart; null: the chart.
  void setPicture(const QPixmap& picture);
  void select(std::optional<std::size_t> row);
  [[nodiscard]] const Plot& plot() const { return m_plot; }
  [[nodiscard]] const QPixmap& picture() const { return m_picture; }

 Q_SIGNALS:
  void clicked(std::size_t row);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  PlotSaver* m_saver;
  Plot m_plot;
  std::optional<std::size_t> m_selected;
  QPixmap m_picture;
};

class ReportPlots : public QWidget {
  Q_OBJECT

 public:
  explicit ReportPlots(QWidget* parent = nullptr);

  /// Sets the request and tests of the rows, which are added one by one.
  void begin(const ReportRequest& request, const std::vector<std::string>& tests);
  void set(std::size_t index, const ReportRow& row);
  /// Enables the panel images once the files of the report are complete.
  void finish();
  /// Selects a row and shows the panel of its test.
  void select(std::optional<std::size_t> row);

 Q_SIGNALS:
  void clicked(std::size_t row);

 private:
  enum Kind { overStates, overAngle, overHogels, overDirections };
  void showPlot();
  [[nodiscard]] QPixmap panel() const;
  [[nodiscard]] bool isOfPanel() const;

  ReportRequest m_request;
  std::vector<std::string> m_tests;
  std::vector<ReportRow> m_rows;
  std::optional<std::size_t> m_selected;
  bool m_isFinished = false;
  QComboBox* m_kind;
  ReportPlotView* m_view;
};

}  // namespace hogelscope
