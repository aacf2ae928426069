// SPDX-License-Identifier: BSD-3-Clause
#include "picture/image_placement.h"

#include <algorithm>
#include <cmath>
#include <span>

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

QRect pixelsUnder(const QRect& clip, const Placement& at, const QSize& image) {
  const QPointF first = at.toImage(clip.topLeft());
  const QPointF end = at.toImage(clip.topLeft() + QPoint(clip.width(), clip.height()));
  const QRect touched(QPoint(int(std::floor(first.x())), int(std::floor(first.y()))),
                      QPoint(int(std::ceil(end.x())) - 1, int(std::ceil(end.y())) - 1));
  return touched & QRect(QPoint(0, 0), image);
}

void ZoomableImage::paint(QPainter& painter, const QRect& clip, const Placement& at) const {
  if (m_image.isNull()) return;
  painter.save();
  painter.setClipRect(clip);
  if (at.zoom < 1) {
    const QSize size(std::max(1, int(std::round(m_image.width() * at.zoom))),
                     std::max(1, int(std::round(m_image.height() * at.zoom))));
    if (m_small.size() != size)
      m_small = m_image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    painter.drawImage(at.origin, m_small);
  } else {
    // Only the visible part, because Qt's coordinates overflow far outside the screen.
    const QRect part = pixelsUnder(clip, at, m_image.size());
    const QRectF target(at.toDevice(part.topLeft()), QSizeF(part.size()) * at.zoom);
    painter.drawImage(target, m_image, part);
  }
  painter.restore();
}

namespace {

/// Returns the mask with a RayEnd as each pixel. A mask without reasons has RayEnd::misses.
QImage withEnds(const QImage& seen) {
  if (seen.format() == QImage::Format_Indexed8) return seen;
  QImage ends = seen.convertToFormat(QImage::Format_Grayscale8);
  for (int y = 0; y < ends.height(); ++y)
    for (uchar& pixel : std::span(ends.scanLine(y), std::size_t(ends.width())))
      pixel = uchar(pixel != 0 ? RayEnd::seen : RayEnd::misses);
  return ends;
}

}  // namespace

QImage hatched(const QImage& seen, const HatchColours& colours) {
  if (seen.isNull()) return {};
  constexpr int period = 8;
  const QImage ends = withEnds(seen);
  QImage pattern(ends.size(), QImage::Format_ARGB32_Premultiplied);
  pattern.fill(Qt::transparent);
  for (int y = 0; y < ends.height(); ++y) {
    const uchar* from = ends.constScanLine(y);
    auto* to = reinterpret_cast<QRgb*>(pattern.scanLine(y));
    for (int x = 0; x < ends.width(); ++x) {
      if (from[x] >= colours.size()) continue;
      const int rising = (x + y) % period;
      const int falling = (x + period - y % period) % period;
      const bool isLine = RayEnd(from[x]) == RayEnd::noRay    ? std::min(rising, falling) < 2
                          : RayEnd(from[x]) == RayEnd::misses ? rising < period / 2
                                                              : falling < period / 2;
      to[x] = (isLine ? colours[from[x]] : colours[from[x]].darker(350)).rgb();
    }
  }
  return pattern;
}

std::array<bool, 3> reasonsIn(const QImage& seen) {
  std::array<bool, 3> has{};
  const QImage ends = withEnds(seen);
  for (int y = 0; y < ends.height(); ++y)
    for (const uchar end : std::span(ends.constScanLine(y), std::size_t(ends.width())))
      if (end < has.size()) has[end] = true;
  return has;
}

QImage hatchOf(RayEnd end, int side, const HatchColours& colours) {
  QImage ends(side, side, QImage::Format_Indexed8);
  ends.fill(uint(end));
  return hatched(ends, colours);
}

}  // namespace hogelscope
