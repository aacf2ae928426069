// SPDX-License-Identifier: BSD-3-Clause
// Drawing of a lens: straight lines of the world in the image, the fold, the area without rays.
#pragma once

#include <QWidget>

#include "core/lens/lens_grid.h"

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

}  // namespace hogelscope
