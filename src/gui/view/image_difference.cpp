// SPDX-License-Identifier: BSD-3-Clause
// The difference of two images, as the simulated view shows it.
#include "gui/view/image_difference.h"

#include "core/metrics/difference.h"

namespace hogelscope {

QImage differenceImage(const QImage& a, const QImage& b, int gain) {
  if (a.size() != b.size()) return {};
  QImage result = a.convertToFormat(QImage::Format_RGB888);
  const QImage other = b.convertToFormat(QImage::Format_RGB888);
  const std::size_t values = 3 * static_cast<std::size_t>(result.width());
  for (int y = 0; y < result.height(); ++y) {
    const std::span row(result.scanLine(y), values);
    writeDifference(row, {other.constScanLine(y), values}, gain, row);
  }
  return result;
}

}  // namespace hogelscope
