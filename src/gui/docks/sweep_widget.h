// SPDX-License-Identifier: BSD-3-Clause
// A sweep of one quantity of the session's design or of its twin, for the current state's eye: its
// controls, the plot of a figure, and where that is within a limit.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "gui/docks/design_parameters.h"
#include "gui/widgets/scrub_field.h"
#include "measure/limit_spans.h"
#include "measure/sweep.h"
#include "page/plot.h"

class QComboBox;
class QLabel;

namespace hogelscope {

struct FigureRow;
class SessionModel;
class Task;

class SweepWidget : public QWidget {
  Q_OBJECT

 public:
  /// `hold` says what stays as it is.
  SweepWidget(SessionModel* model, std::function<Hold()> hold, QWidget* parent = nullptr);
  ~SweepWidget() override;

  /// Returns the chosen figure of the last sweep; no series before one.
  [[nodiscard]] Plot plot() const;
  /// Returns the plot's row that is read out; none if the mouse is at no point.
  [[nodiscard]] std::optional<std::size_t> hovered() const { return m_hovered; }
  void hover(std::optional<std::size_t> row);
  /// Gives the session the value of a row of the plot, as one edit.
  void apply(std::size_t row);

 Q_SIGNALS:
  void plotChanged();

 private:
  struct Swept {
    const DesignParameter* parameter = nullptr;  ///< none: nothing was swept
    Hold hold = Hold::size;
    std::vector<double> values;
    std::vector<std::string> figures{};  ///< those that were measured
    std::vector<SweepRow> rows{};        ///< of each value
  };
  /// The limit that good designs keep for a figure.
  struct Limit {
    bool isLeast = true;
    std::optional<double> value;  ///< none: the figure has no limit
  };

  [[nodiscard]] const DesignParameter& parameter() const;
  [[nodiscard]] const FigureRow& figure() const;
  void addChoices();
  void chooseParameter();
  void chooseFigure();
  void showLimit();
  void keepLimit();
  void showAnswer();
  [[nodiscard]] QString answer() const;
  [[nodiscard]] static QString placeText(const LimitSpan& span);
  void propose();
  void sweep();
  void show(const Swept& swept);
  void forget();

  SessionModel* m_model;
  std::function<Hold()> m_hold;
  Swept m_swept;
  int m_opening = 0;  ///< the number of sessions opened so far
  Task* m_task;
  std::vector<Limit> m_limits;  ///< of each figure
  std::optional<std::size_t> m_hovered;
  QComboBox *m_parameter, *m_figure, *m_sense;
  RealField *m_from, *m_to, *m_limit;
  QLabel *m_answer, *m_note;
};

}  // namespace hogelscope
