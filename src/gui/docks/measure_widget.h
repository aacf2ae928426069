// SPDX-License-Identifier: BSD-3-Clause
// The dock "Measure": what the display shows to the current eye, and whether the content fits.
// Closed forms follow every edit; when edits rest, the engine's own figures take their place.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "io/scene/view_source.h"
#include "measure/depth_budget_run.h"
#include "page/map_plot.h"

class QLabel;
class QPushButton;

namespace hogelscope {

class PolledBar;
class SessionModel;
class Task;

class MeasureWidget : public QWidget {
  Q_OBJECT

 public:
  explicit MeasureWidget(QWidget* parent = nullptr);
  ~MeasureWidget() override;

  void setModel(SessionModel* model);
  /// Sets the session's light field; none while there is no one.
  void setSource(const std::optional<ViewSource>& source);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  /// The plots of the session as it is.
  struct Shown {
    MapPlot contrast;
    MapPlot zone;
    std::optional<DepthFigures> depths;
    double end = 1;  ///< of the depths' bars, dioptres
    std::optional<DepthProposal> proposal;
  };

  QWidget* makePlot(const char* name, const QString& title, const QString& tip);
  void follow();
  void showClosedForms();
  void simulate();
  void showDepths(const DepthFigures& figures, std::optional<DepthProposal> proposal,
                  const QString& obstacle);
  void showStatus(const QString& text);
  void fit();
  [[nodiscard]] Session ofCurrent() const;
  [[nodiscard]] std::optional<PanelParams> display() const;

  SessionModel* m_model = nullptr;
  std::optional<ViewSource> m_source;
  Shown m_shown;
  QTimer m_rest;  ///< until edits have rested
  Task* m_task;
  PolledBar* m_progress;
  QLabel* m_status;
  QPushButton* m_fit;
};

}  // namespace hogelscope
