// SPDX-License-Identifier: BSD-3-Clause
// The speed-accuracy dock: measures the session on demand and shows chart, table and recommended
// methods. A click on any of them chooses its method.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "chart/tradeoff_chart.h"
#include "study/tradeoff.h"

class QLabel;
class QPushButton;

namespace Ui {
class TradeoffWidget;
}

namespace hogelscope {

class PlotSaver;
class Task;

/// The chart without controls. The row under the pointer is described beside its point.
class TradeoffChartWidget : public QWidget {
  Q_OBJECT

 public:
  explicit TradeoffChartWidget(QWidget* parent = nullptr);
  void setChart(TradeoffChart chart);
  void select(std::optional<std::size_t> row);
  /// Describes a row, or none.
  void point(std::optional<std::size_t> row);
  [[nodiscard]] const TradeoffChart& chart() const { return m_chart; }

 Q_SIGNALS:
  void clicked(std::size_t row);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::optional<std::size_t> rowAt(const QPointF& place) const;

  TradeoffChart m_chart;
  PlotSaver* m_saver;
  QLabel* m_details;
};

class TradeoffWidget : public QWidget {
  Q_OBJECT

 public:
  explicit TradeoffWidget(QWidget* parent = nullptr);
  ~TradeoffWidget() override;

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

 protected:
  bool event(QEvent* event) override;

 private:
  struct Result {
    std::vector<TradeoffRow> rows;
    double seconds = 0;
  };

  void connectParts();
  void measure();
  void choose(std::optional<std::size_t> row);
  void showTask();
  void show(Question question);
  void showStatus();
  void showChoice();
  void fillTable(const std::vector<TradeoffRow>& rows);
  void arrange();
  [[nodiscard]] bool isLow() const;
  [[nodiscard]] const std::vector<TradeoffRow>& rows() const;
  [[nodiscard]] std::size_t rowOfLine(int line) const;

  std::function<std::vector<RenderJob>()> m_viewsNow;
  std::array<Result, 2> m_results;  ///< of each question; without rows if it is not measured
  Question m_question = Question::idealPicture;
  QString m_chosen;  ///< the chosen method's name; empty: the session's own
  bool m_canMeasure = false;
  std::unique_ptr<Ui::TradeoffWidget> m_ui;
  Task* m_task;
  std::array<QPushButton*, purposes.size()> m_cards{};
};

}  // namespace hogelscope
