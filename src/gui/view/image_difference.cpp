// SPDX-License-Identifier: BSD-3-Clause
// The difference of two images, as the simulated view shows it.
#include "gui/view/image_difference.h"

#include <algorithm>
#include <cstdlib>

namespace hogelscope {

QImage differenceImage(const QImage& a, const QImage& b, int gain) {
  if (a.size() != b.size()) return {};
  QImage result = a.convertToFormat(QImage::Format_RGB888);
  const QImage other = b.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < result.height(); ++y) {
    uchar* to = result.scanLine(y);
    const uchar* from = other.constScanLine(y);
    for (int k = 0; k < 3 * result.width(); ++k)
      to[k] = static_cast<uchar>(std::min(gain * std::abs(to[k] - from[k]), 255));
  }
  return result;
}

}  // namespace hogelscope
