// SPDX-License-Identifier: BSD-3-Clause
// A sweep of one quantity of the session's design, for the current state's eye: its controls, and
// the plot of a figure.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "gui/docks/design_parameters.h"
#include "gui/widgets/scrub_field.h"
#include "measure/sweep.h"
#include "page/plot.h"

class QComboBox;
class QLabel;

namespace hogelscope {

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

 Q_SIGNALS:
  void plotChanged();

 private:
  struct Swept {
    const DesignParameter* parameter = nullptr;  ///< none: nothing was swept
    std::vector<double> values;
    std::vector<SweepRow> rows;  ///< of each value
  };

  [[nodiscard]] const DesignParameter& parameter() const;
  void propose();
  void sweep();
  void show(const Swept& swept);
  void forget();

  SessionModel* m_model;
  std::function<Hold()> m_hold;
  Swept m_swept;
  int m_opening = 0;  ///< the number of sessions opened so far
  Task* m_task;
  QComboBox *m_parameter, *m_figure;
  RealField *m_from, *m_to;
  QLabel* m_note;
};

}  // namespace hogelscope
