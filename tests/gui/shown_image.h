// SPDX-License-Identifier: BSD-3-Clause
// Comparison of images shown by the window with expected images and colours.
#pragma once

#include <QColor>
#include <QImage>
#include <algorithm>

#include "core/optics/image.h"

/// Whether all pixels are equal.
inline bool equals(const QImage& shown, const hogelscope::Image& expected) {
  if (shown.width() != expected.width || shown.height() != expected.height) return false;
  const QImage rgb = shown.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < rgb.height(); ++y)
    if (!std::equal(rgb.constScanLine(y), rgb.constScanLine(y) + qsizetype(3) * rgb.width(),
                    expected.rgb.begin() + 3 * std::ptrdiff_t(y) * rgb.width()))
      return false;
  return true;
}

/// Returns the distance of 8-bit colours, summed over all channels.
inline int distance(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
         std::abs(a.blue() - b.blue());
}

/// Returns the number of pixels with nearly this colour.
inline int count(const QImage& image, const QColor& colour, int tolerance = 30) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (distance(image.pixelColor(x, y), colour) < tolerance) ++found;
  return found;
}
