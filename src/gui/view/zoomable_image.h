// SPDX-License-Identifier: BSD-3-Clause
// An image painted at any zoom: its own pixels above one to one, averages below.
#pragma once

#include <QImage>
#include <QPainter>

#include "gui/view/image_placement.h"

namespace hogelscope {

class ZoomableImage {
 public:
  ZoomableImage() = default;
  explicit ZoomableImage(const QImage& image) : m_image(image) {}

  [[nodiscard]] const QImage& image() const { return m_image; }
  /// Paints the image. `clip` is in device pixels, as are all of the painter's coordinates.
  void paint(QPainter& painter, const QRect& clip, const Placement& at) const;

 private:
  QImage m_image;
  mutable QImage m_small;  ///< cached by the last painting below one to one
};

/// Returns stripes where `seen` is 0, transparent elsewhere; null for a null mask.
QImage hatched(const QImage& seen);

/// Paints lines between the pixels, from 8 device pixels per pixel on.
void paintPixelGrid(QPainter& painter, const QRect& clip, const Placement& at, const QSize& image);

}  // namespace hogelscope
