// SPDX-License-Identifier: BSD-3-Clause
// Zoom and pan: the placement of an image in a part of a widget. All positions are in device
// pixels, so that one to one means one screen pixel per image pixel.
#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QPointF>
#include <QRect>
#include <QSize>
#include <array>

#include "core/optics/pixel_inspection.h"

namespace hogelscope {

/// The part of the image that linked views share.
struct Viewport {
  bool fits = true;  ///< fits the pane; the other members are then at their defaults
  double zoom = 1;   ///< device pixels per image pixel
  QPointF centre;    ///< the image point in the pane's middle; pixel x reaches from x to x + 1
  bool operator==(const Viewport&) const = default;
};

struct Placement {
  QPointF origin;  ///< of the image's top left corner, in whole device pixels
  double zoom = 1;

  [[nodiscard]] QPointF toImage(const QPointF& device) const { return (device - origin) / zoom; }
  [[nodiscard]] QPointF toDevice(const QPointF& image) const { return origin + image * zoom; }
};

/// Returns the pixels that a part of the screen touches.
QRect pixelsUnder(const QRect& clip, const Placement& at, const QSize& image);

/// Returns the placement of an image, which must not be empty.
Placement placementOf(const Viewport& viewport, const QRect& pane, const QSize& image);

/// Zooms by `steps` steps along powers of √2 (which include 1, 2, 4 …), between 1/32 and 64. The
/// image point at `around` stays in place.
Viewport zoomed(const Viewport& viewport, const QRect& pane, const QSize& image, int steps,
                const QPointF& around);
/// Sets the zoom; the middle stays approximately in place.
Viewport zoomedTo(const Viewport& viewport, const QRect& pane, const QSize& image, double zoom);
/// Moves the image by `device` device pixels.
Viewport moved(const Viewport& viewport, const QRect& pane, const QSize& image,
               const QPointF& device);
/// Limits the centre to the image.
Viewport limitCentre(const Viewport& viewport, const QSize& image);

/// An image painted at any zoom: its own pixels above one to one, averages below.
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

/// The colours of a mask's patterns, by RayEnd.
using HatchColours = std::array<QColor, 3>;

/// Returns a pattern where `seen` is black, transparent elsewhere; null for a null mask. The index
/// in an indexed mask, a RayEnd, chooses the pattern.
QImage hatched(const QImage& seen, const HatchColours& colours);
/// Returns which RayEnd the hatched pixels of the mask have, and whether it has any.
std::array<bool, 3> reasonsIn(const QImage& seen);
/// Returns a square of a RayEnd's pattern.
QImage hatchOf(RayEnd end, int side, const HatchColours& colours);

}  // namespace hogelscope
