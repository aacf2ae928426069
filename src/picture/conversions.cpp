// SPDX-License-Identifier: BSD-3-Clause
#include "picture/conversions.h"

#include <algorithm>
#include <span>

#include "core/base/parallel.h"
#include "core/engine/hogel_pixels.h"

namespace hogelscope {

QImage toQImage(const Image& image) {
  return QImage(image.rgb.data(), image.width, image.height, qsizetype{3} * image.width,
                QImage::Format_RGB888)
      .copy();
}

Image toImage(const QImage& picture, const QImage& mask, const QRect& part) {
  const QImage rgb = picture.copy(part).convertToFormat(QImage::Format_RGB888);
  const QImage seen =
      mask.isNull() ? QImage() : mask.copy(part).convertToFormat(QImage::Format_Grayscale8);
  Image image(rgb.width(), rgb.height());
  for (int y = 0; y < image.height; ++y) {
    const std::size_t row = std::size_t(y) * std::size_t(image.width);
    std::copy_n(rgb.constScanLine(y), 3 * image.width, &image.rgb[3 * row]);
    if (seen.isNull())
      std::fill_n(&image.seen[row], image.width, std::uint8_t(255));
    else
      std::copy_n(seen.constScanLine(y), image.width, &image.seen[row]);
  }
  return image;
}

std::vector<std::uint8_t> bytesOf(const QImage& picture, bool hasAlpha) {
  const QImage image =
      picture.convertToFormat(hasAlpha ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
  const int row = (hasAlpha ? 4 : 3) * image.width();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(std::size_t(row) * std::size_t(image.height()));
  for (int y = 0; y < image.height(); ++y)
    bytes.insert(bytes.end(), image.constScanLine(y), image.constScanLine(y) + row);
  return bytes;
}

QImage withReasons(const QImage& seen, const RenderJob& job, const Progress& progress) {
  std::vector<std::uint8_t> mask;
  for (int y = 0; y < seen.height(); ++y)
    mask.insert(mask.end(), seen.constScanLine(y), seen.constScanLine(y) + seen.width());
  const std::vector<RayEnd> ends = rayEnds(job, mask, parallelRows, progress);
  QImage reasons(seen.size(), QImage::Format_Indexed8);
  reasons.setColorTable({qRgb(0, 0, 0), qRgb(0, 0, 0), qRgb(0, 0, 0), qRgb(255, 255, 255)});
  for (int y = 0; y < seen.height(); ++y)
    for (int x = 0; x < seen.width(); ++x) {
      const auto at = std::size_t(y) * std::size_t(seen.width()) + std::size_t(x);
      // A coarse image may miss a pixel whose middle ray just comes into the field.
      const bool isMissed = mask[at] == 0 && ends[at] == RayEnd::seen;
      reasons.scanLine(y)[x] = uchar(isMissed ? RayEnd::outsideField : ends[at]);
    }
  return reasons;
}

}  // namespace hogelscope
