// SPDX-License-Identifier: BSD-3-Clause
// The report dock's plots: PSNR over the states or the viewing angle, and the error on the panel.
#pragma once

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
