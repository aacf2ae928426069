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
  [[nodiscard]] QRectF cell(const QRectF& square, int k) const;
  void paint(QPainter& painter, const QSizeF& size) const;
  void paintCells(QPainter& painter, const QRectF& square) const;
  void paintNumbers(QPainter& painter, const QRectF& square) const;
  void paintSigma(QPainter& painter, const QRectF& square) const;

  PsfParams m_params;
  std::vector<double> m_weights;
};

}  // namespace hogelscope
