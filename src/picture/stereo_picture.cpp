// SPDX-License-Identifier: BSD-3-Clause
#include "picture/stereo_picture.h"

#include <algorithm>

#include "picture/conversions.h"

namespace hogelscope {

namespace {

QImage beside(const QImage& first, const QImage& second) {
  QImage both(first.width() + second.width(), first.height(), first.format());
  both.setColorTable(first.colorTable());
  const auto bytes = std::size_t(first.depth()) / 8 * std::size_t(first.width());
  for (int y = 0; y < first.height(); ++y) {
    std::copy_n(first.constScanLine(y), bytes, both.scanLine(y));
    std::copy_n(second.constScanLine(y), bytes, both.scanLine(y) + bytes);
  }
  return both;
}

QImage seenByOne(const QImage& left, const QImage& right) {
  QImage either = left;
  for (int y = 0; y < left.height(); ++y)
    std::transform(left.constScanLine(y), left.constScanLine(y) + left.width(),
                   right.constScanLine(y), either.scanLine(y),
                   [](uchar a, uchar b) { return std::max(a, b); });
  return either;
}

}  // namespace

QImage joined(const QImage& left, const QImage& right, StereoMode mode) {
  if (mode == StereoMode::sideBySide) return beside(left, right);
  if (mode == StereoMode::crossEyed) return beside(right, left);
  if (left.depth() == 8) return seenByOne(left, right);
  const auto imageOf = [](const QImage& picture) {
    Image image(picture.width(), picture.height());
    image.rgb = bytesOf(picture);
    return image;
  };
  return toQImage(stereoImage(imageOf(left), imageOf(right), mode));
}

}  // namespace hogelscope
