// SPDX-License-Identifier: BSD-3-Clause
// Sliders over the quantities of a design. The display as it was opened, A, is kept beside the
// edited one, B: a mark on each slider shows A, and a button chooses either.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "gui/docks/design_parameters.h"

class QAbstractButton;
class QLabel;
class QSlider;

namespace hogelscope {

class DesignSlider;
class SessionModel;

class DesignSliders : public QWidget {
  Q_OBJECT

 public:
  explicit DesignSliders(SessionModel* model, QWidget* parent = nullptr);

  [[nodiscard]] Hold hold() const { return m_hold; }

 Q_SIGNALS:
  /// Asks for views of display A beside those of the session's own.
  void comparisonAsked(const hogelscope::DisplayParams& opened);

 private:
  struct Row {
    const DesignParameter& parameter;
    QLabel* value;
    DesignSlider* slider;
  };

  [[nodiscard]] QWidget* makeDesigns();
  [[nodiscard]] QWidget* makeHold();
  [[nodiscard]] QWidget* makeRow(const DesignParameter& parameter);
  void keepOpened();
  void choose(const DisplayParams& display);
  void slide(const Row& row);
  void follow();

  SessionModel* m_model;
  DisplayParams m_opened;                 ///< A
  std::optional<DisplayParams> m_edited;  ///< B, once there was one
  Hold m_hold = Hold::size;
  std::vector<Row> m_rows;
  QAbstractButton *m_chooseA = nullptr, *m_chooseB = nullptr, *m_compare = nullptr;
};

}  // namespace hogelscope
