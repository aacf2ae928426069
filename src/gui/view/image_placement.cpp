// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/image_placement.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

QPointF middleOf(const QRect& pane) {
  return {pane.x() + pane.width() / 2.0, pane.y() + pane.height() / 2.0};
}

Viewport viewportAt(const Placement& at, const QRect& pane) {
  return {false, at.zoom, at.toImage(middleOf(pane))};
}

/// Returns the placement with an unrounded origin, so that rounding errors do not accumulate.
Placement unroundedPlacement(const Viewport& viewport, const QRect& pane, const QSize& image) {
  const double zoom = viewport.fits ? std::min(double(pane.width()) / image.width(),
                                               double(pane.height()) / image.height())
                                    : viewport.zoom;
  const QPointF centre =
      viewport.fits ? QPointF(image.width() / 2.0, image.height() / 2.0) : viewport.centre;
  return {middleOf(pane) - centre * zoom, zoom};
}

}  // namespace

Placement placementOf(const Viewport& viewport, const QRect& pane, const QSize& image) {
  const Placement exact = unroundedPlacement(viewport, pane, image);
  return {{std::round(exact.origin.x()), std::round(exact.origin.y())}, exact.zoom};
}

Viewport zoomed(const Viewport& viewport, const QRect& pane, const QSize& image, int steps,
                const QPointF& around) {
  const Placement from = unroundedPlacement(viewport, pane, image);
  const double step = 2 * std::log2(from.zoom);
  const double next = steps > 0 ? std::floor(step + 1e-6) : std::ceil(step - 1e-6);
  const double zoom = std::exp2(std::clamp(next + steps, -10.0, 12.0) / 2);
  return viewportAt({around - from.toImage(around) * zoom, zoom}, pane);
}

Viewport zoomedTo(const Viewport& viewport, const QRect& pane, const QSize& image, double zoom) {
  const Placement from = unroundedPlacement(viewport, pane, image);
  return {false, zoom, from.toImage(middleOf(pane))};
}

Viewport moved(const Viewport& viewport, const QRect& pane, const QSize& image,
               const QPointF& device) {
  const Placement from = unroundedPlacement(viewport, pane, image);
  return viewportAt({from.origin + device, from.zoom}, pane);
}

Viewport limitCentre(const Viewport& viewport, const QSize& image) {
  if (viewport.fits) return {};
  if (image.isEmpty()) return viewport;
  return {false,
          viewport.zoom,
          {std::clamp(viewport.centre.x(), 0.0, double(image.width())),
           std::clamp(viewport.centre.y(), 0.0, double(image.height()))}};
}

}  // namespace hogelscope
