// SPDX-License-Identifier: BSD-3-Clause
// Drawings of parameters: a lens by the straight lines of the world in the image, the fold and the
// area without rays; the light leakage by the taps of its window, with their weights, and the
// sigma of the Gaussian.
#pragma once

#include <QWidget>

#include "core/lens/lens_grid.h"
#include "core/optics/psf.h"

class QPainterPath;

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
  void paint(QPainter& painter, const QSizeF& size) const;
  [[nodiscard]] QTransform fromImage(const QSizeF& size) const;
  [[nodiscard]] QRectF border() const;
  [[nodiscard]] QPainterPath foldPath() const;
  void paintLines(QPainter& painter, const QTransform& transform) const;
  void paintFold(QPainter& painter, const QTransform& transform) const;

  LensGrid m_grid;
  PlotSaver* m_saver;
};

/// A drawing of the light leakage: the window's taps with their weights, and the Gaussian's sigma.
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
