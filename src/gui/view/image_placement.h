// SPDX-License-Identifier: BSD-3-Clause
// Zoom and pan: where an image lies in the part of a widget that shows it. All positions are in
// device pixels, so that one to one means one of the screen's own pixels.
#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>

namespace hogelscope {

/// What linked views share.
struct Viewport {
  bool fits = true;  ///< as large as fits; the others are then at their defaults
  double zoom = 1;   ///< device pixels per image pixel
  QPointF centre;    ///< the image's point in the pane's middle; pixel x reaches from x to x + 1
  bool operator==(const Viewport&) const = default;
};

struct Placement {
  QPointF origin;  ///< of the image's top left corner, whole device pixels
  double zoom = 1;

  [[nodiscard]] QPointF toImage(const QPointF& device) const { return (device - origin) / zoom; }
  [[nodiscard]] QPointF toDevice(const QPointF& image) const { return origin + image * zoom; }
};

/// The image must have pixels.
Placement placementOf(const Viewport& viewport, const QRect& pane, const QSize& image);

/// `steps` further along zooms that are powers of √2 (so that 1, 2, 4 … are among them), between
/// 1/32 and 64; the image's point at `around` stays there.
Viewport zoomed(const Viewport& viewport, const QRect& pane, const QSize& image, int steps,
                const QPointF& around);
/// At a zoom of its own, about the same middle.
Viewport zoomedTo(const Viewport& viewport, const QRect& pane, const QSize& image, double zoom);
/// The image moves by `device`.
Viewport moved(const Viewport& viewport, const QRect& pane, const QSize& image,
               const QPointF& device);
/// The middle shows the image, not what is beside it.
Viewport limitCentre(const Viewport& viewport, const QSize& image);

}  // namespace hogelscope
