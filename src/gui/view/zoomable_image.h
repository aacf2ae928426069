// SPDX-License-Identifier: BSD-3-Clause
// One image painted at any zoom: its own pixels above one to one, averages below.
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
  /// `clip`, as all of the painter's coordinates, in device pixels.
  void paint(QPainter& painter, const QRect& clip, const Placement& at) const;

 private:
  QImage m_image;
  mutable QImage m_small;  ///< kept from the last painting below one to one
};

/// Stripes where `seen` is 0, nothing elsewhere. Null for a null mask.
QImage hatched(const QImage& seen);

/// Lines between the pixels, from 8 device pixels per pixel on.
void paintPixelGrid(QPainter& painter, const QRect& clip, const Placement& at, const QSize& image);

}  // namespace hogelscope
