// SPDX-License-Identifier: BSD-3-Clause
// lenses.png: where in a lens' own picture each way to invert it holds.
#pragma once

#include "chart/painting.h"
#include "study/stability.h"

namespace hogelscope {

/// The most lenses of one picture; later ones are in the table alone.
constexpr std::size_t mostLensPictures = 24;

/// Paints one row for each lens from the `first` on, one column for each method, and a legend
/// below: the outcome of every pixel that was measured.
void paintLensPictures(QPainter& painter, const QSizeF& size, const Stability& stability,
                       std::size_t first);

/// The size, in points, that the pictures are drawn for.
QSize lensPicturesSize(const Stability& stability, std::size_t first);

}  // namespace hogelscope
