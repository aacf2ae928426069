// SPDX-License-Identifier: BSD-3-Clause
// A drawing of the light leakage: the window's taps with their weights, and the Gaussian's sigma.
#pragma once

#include <QWidget>

#include "core/optics/psf.h"

namespace hogelscope {

class KernelWidget : public QWidget {
  Q_OBJECT

 public:
  explicit KernelWidget(QWidget* parent = nullptr);

  void setParams(const PsfParams& params);
  /// Of one direction of a hogel (psfKernelAt).
  void setWeights(const PsfParams& params, const std::vector<double>& weights);
  /// None where the parameters give no kernel.
  [[nodiscard]] const std::vector<double>& weights() const { return m_weights; }
  /// What the tap at a position weighs, as the drawing says it; "" beside the drawing.
  [[nodiscard]] QString textAt(const QPointF& position) const;

  [[nodiscard]] QSize sizeHint() const override { return {160, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF cell(const QRectF& square, int k) const;
  void paint(QPainter& painter, const QSizeF& size) const;
  void paintCells(QPainter& painter, const QRectF& square) const;
  void paintNumbers(QPainter& painter, const QRectF& square) const;
  void paintSigma(QPainter& painter, const QRectF& square) const;

  PsfParams m_params;
  std::vector<double> m_weights;
};

}  // namespace hogelscope
