// SPDX-License-Identifier: BSD-3-Clause
// Drawings of parameters: a lens (chart/lens_drawing) and the light leakage (chart/kernel_drawing).
#pragma once

#include <QWidget>

#include "core/lens/lens_grid.h"
#include "core/optics/psf.h"

namespace hogelscope {

class PlotSaver;

/// Draws a lens, pale while disabled.
class LensWidget : public QWidget {
  Q_OBJECT

 public:
  explicit LensWidget(QWidget* parent = nullptr);

  void setLens(const LensGrid& grid);

  [[nodiscard]] QSize sizeHint() const override { return {160, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  LensGrid m_grid;
  PlotSaver* m_saver;
};

/// Draws the light leakage. A tooltip tells the weight of a tap.
class KernelWidget : public QWidget {
  Q_OBJECT

 public:
  explicit KernelWidget(QWidget* parent = nullptr);

  void setParams(const PsfParams& params);
  /// Shows the weights of one direction of a hogel (psfKernelAt).
  void setWeights(const PsfParams& params, const std::vector<double>& weights);
  /// Empty if the parameters define no kernel.
  [[nodiscard]] const std::vector<double>& weights() const { return m_weights; }
  /// Returns the text for the weight of the tap at a position; "" outside the drawing.
  [[nodiscard]] QString textAt(const QPointF& position) const;

  [[nodiscard]] QSize sizeHint() const override { return {160, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  PsfParams m_params;
  std::vector<double> m_weights;
};

}  // namespace hogelscope
