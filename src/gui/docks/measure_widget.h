// SPDX-License-Identifier: BSD-3-Clause
// The dock "Measure": sliders of the design, what the display shows to the current eye, whether the
// content fits, a sweep. Closed forms follow every edit; when edits rest, the engine's own figures
// take their place.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "io/scene/view_source.h"
#include "measure/depth_budget_run.h"
#include "page/map_plot.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace hogelscope {

class DesignNumbersWidget;
class DesignSliders;
class SessionModel;
class SweepWidget;
class Task;

class MeasureWidget : public QWidget {
  Q_OBJECT

 public:
  explicit MeasureWidget(QWidget* parent = nullptr);
  ~MeasureWidget() override;

  void setModel(SessionModel* model);
  /// Sets the session's light field; none while there is no one.
  void setSource(const std::optional<ViewSource>& source);

 Q_SIGNALS:
  /// Passes the tint of the current state's view, in its size, transparent where content is sharp;
  /// null: none.
  void tintChanged(const QImage& tint);
  /// Asks for views on the display as it was opened beside those on the session's own.
  void comparisonAsked(const hogelscope::DisplayParams& opened);

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
    PixelDepths pixels;  ///< of the tint; empty while it is not known
    QSize size;          ///< of its picture
  };

  void addControls();
  void addPlots(QGridLayout* grid);
  void follow();
  void showClosedForms();
  void simulate();
  void showDepths(const StatesDepths& depths);
  void showFit();
  void showTint();
  void showStatus(const QString& text);
  void fit();
  [[nodiscard]] Session ofCurrent() const;
  [[nodiscard]] std::optional<PanelParams> display() const;

  SessionModel* m_model = nullptr;
  std::optional<ViewSource> m_source;
  Shown m_shown;
  QTimer m_rest;  ///< until edits have rested
  Task* m_task;
  QLabel* m_status;
  QPushButton* m_fit;
  QCheckBox* m_tints;
  QComboBox* m_limit;  ///< of tint and fit: a DepthLimit
  QScrollArea* m_area;
  QVBoxLayout* m_controls;  ///< in it
  QVBoxLayout* m_right;     ///< numbers over plots
  DesignSliders* m_sliders = nullptr;
  SweepWidget* m_sweep = nullptr;
  DesignNumbersWidget* m_numbers = nullptr;
};

}  // namespace hogelscope
