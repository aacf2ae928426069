// SPDX-License-Identifier: BSD-3-Clause
// The difference of two images, as the simulated view shows it.
#pragma once

#include <QImage>

namespace hogelscope {

/// gain · |a − b| of each channel, limited to 255. Null where the sizes differ.
QImage differenceImage(const QImage& a, const QImage& b, int gain);

}  // namespace hogelscope
