// SPDX-License-Identifier: BSD-3-Clause
// The speed-accuracy dock: measures the session on demand and shows the chart. A click on a point
// chooses its method.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "chart/tradeoff_chart.h"
#include "study/tradeoff.h"

class QPushButton;
class QSpinBox;

namespace hogelscope {

class PlotSaver;
class PolledBar;
class Task;

/// The chart without controls.
class TradeoffChartWidget : public QWidget {
  Q_OBJECT

 public:
  explicit TradeoffChartWidget(QWidget* parent = nullptr);
  void setChart(TradeoffChart chart);
  void select(std::optional<std::size_t> row);
  [[nodiscard]] const TradeoffChart& chart() const { return m_chart; }

 Q_SIGNALS:
  void clicked(std::size_t row);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  TradeoffChart m_chart;
  PlotSaver* m_saver;
};

class TradeoffWidget : public QWidget {
  Q_OBJECT

 public:
  explicit TradeoffWidget(QWidget* parent = nullptr);

  /// Sets the function that gives the views of a measurement, when one begins.
  void setViews(std::function<std::vector<RenderJob>()> views) { m_viewsNow = std::move(views); }
  /// Drops the results of other views than those that setViews() gives now, and stops a measurement
  /// of them. `canMeasure`: there are views.
  void forget(bool canMeasure);
  /// Clears the choice of a method without emitting methodChosen().
  void forgetChoice();

 Q_SIGNALS:
  /// Passes the chosen method; none: the session's own.
  void methodChosen(const std::optional<hogelscope::NamedMethod>& method);
  void failed(const QString& line);

 private:
  void measureOrStop();
  void stop();
  void show(const Tradeoff& tradeoff);
  void choose(std::optional<std::size_t> row);
  void showIdle();

  std::function<std::vector<RenderJob>()> m_viewsNow;
  std::vector<RenderJob> m_views;  ///< those that are measured, or shown in the chart
  bool m_canMeasure = false;
  Task* m_task;
  TradeoffChartWidget* m_chart;
  QPushButton* m_measureButton;
  QSpinBox* m_budgetBox;
  QPushButton* m_defaultButton;
  PolledBar* m_progress;
};

}  // namespace hogelscope
