// SPDX-License-Identifier: BSD-3-Clause
// The plots of a report, and the pictures of its chosen state.
#pragma once

#include <QPixmap>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "gui/docks/report_results.h"
#include "page/plot.h"

namespace Ui {
class ReportPlots;
}

namespace hogelscope {

class PlotSaver;

/// A single plot, or an image with a colour bar. A click on a point emits its row.
class ReportPlotView : public QWidget {
  Q_OBJECT

 public:
  explicit ReportPlotView(QWidget* parent);
  void setPlot(Plot plot);
  /// Shows an image of the panel in place of the chart; null: the chart. `most` is the value at the
  /// end of its colours; "": it is no map.
  void setPicture(const QPixmap& picture, const QString& most = {});
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
  QString m_most;
};

class ReportPlots : public QWidget {
  Q_OBJECT

 public:
  explicit ReportPlots(const ReportData& report);
  ~ReportPlots() override;

  /// Shows the plots of a test and, if it is among its states, a state.
  void showTest(std::size_t test, std::optional<std::size_t> state);

 Q_SIGNALS:
  void rowClicked(std::size_t row);
  void testClicked(std::size_t test);
  void compareAsked();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum Kind { overWindow, overStates, overAngle, overHogels, overDirections };
  void showKind();
  void showPanel();
  void showPictures();

  const ReportData& m_data;
  std::size_t m_test = 0;
  std::optional<std::size_t> m_row;
  std::unique_ptr<Ui::ReportPlots> m_ui;
  std::array<ReportPlotView*, 3> m_images{};  ///< reference, test, difference
};

}  // namespace hogelscope
