// SPDX-License-Identifier: BSD-3-Clause
// A twin in the 3-D scene: what is wrong where on the panel, the shifts of its lenses as arrows and
// its hogels' gains as colours.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "core/panel/twin.h"
#include "gui/widgets/colours.h"

class vtkRenderer;

namespace hogelscope {

class TwinActors {
 public:
  explicit TwinActors(vtkRenderer* renderer);

  void setColours(const Tokens& colours);
  /// Shows a twin of a display with its hogels; null: none. Arrows are of every hogel, or of some
  /// evenly spread ones, in one scale: the longest is as long as they are apart.
  void show(const PanelParams& display, const Twin* twin);
  void setVisible(bool isVisible);
  /// Returns the numbers of arrows, and of hogels with a colour.
  [[nodiscard]] int arrows() const;
  [[nodiscard]] int colours() const { return int(m_gains->GetNumberOfCells()); }

 private:
  vtkNew<vtkPolyData> m_shifts;
  vtkNew<vtkPolyData> m_gains;
  vtkNew<vtkActor> m_arrows;
  vtkNew<vtkActor> m_squares;
};

}  // namespace hogelscope
