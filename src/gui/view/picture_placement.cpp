// SPDX-License-Identifier: BSD-3-Clause
// Zoom and pan: where a picture lies in the part of a widget that shows it.
#include "gui/view/picture_placement.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

QPointF middleOf(const QRect& pane) {
  return {pane.x() + pane.width() / 2.0, pane.y() + pane.height() / 2.0};
}

Viewport with(const Placement& at, const QRect& pane) {
  return {false, at.zoom, at.toPicture(middleOf(pane))};
}

/// Before its origin is rounded, so that roundings do not add up from step to step.
Placement exactly(const Viewport& viewport, const QRect& pane, const QSize& picture) {
  const double zoom = viewport.fits ? std::min(double(pane.width()) / picture.width(),
                                               double(pane.height()) / picture.height())
                                    : viewport.zoom;
  const QPointF centre =
      viewport.fits ? QPointF(picture.width() / 2.0, picture.height() / 2.0) : viewport.centre;
  return {middleOf(pane) - centre * zoom, zoom};
}

}  // namespace

Placement place(const Viewport& viewport, const QRect& pane, const QSize& picture) {
  const Placement exact = exactly(viewport, pane, picture);
  return {{std::round(exact.origin.x()), std::round(exact.origin.y())}, exact.zoom};
}

Viewport zoomed(const Viewport& viewport, const QRect& pane, const QSize& picture, int steps,
                const QPointF& around) {
  const Placement from = exactly(viewport, pane, picture);
  const double step = 2 * std::log2(from.zoom);
  const double next = steps > 0 ? std::floor(step + 1e-6) : std::ceil(step - 1e-6);
  const double zoom = std::exp2(std::clamp(next + steps, -10.0, 12.0) / 2);
  return with({around - from.toPicture(around) * zoom, zoom}, pane);
}

Viewport zoomedTo(const Viewport& viewport, const QRect& pane, const QSize& picture, double zoom) {
  const Placement from = exactly(viewport, pane, picture);
  return {false, zoom, from.toPicture(middleOf(pane))};
}

Viewport moved(const Viewport& viewport, const QRect& pane, const QSize& picture,
               const QPointF& device) {
  const Placement from = exactly(viewport, pane, picture);
  return with({from.origin + device, from.zoom}, pane);
}

Viewport limited(const Viewport& viewport, const QSize& picture) {
  if (viewport.fits) return {};
  if (picture.isEmpty()) return viewport;
  return {false,
          viewport.zoom,
          {std::clamp(viewport.centre.x(), 0.0, double(picture.width())),
           std::clamp(viewport.centre.y(), 0.0, double(picture.height()))}};
}

}  // namespace hogelscope
