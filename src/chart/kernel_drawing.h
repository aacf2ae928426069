// SPDX-License-Identifier: BSD-3-Clause
// Paints the light leakage: the taps of its window with their weights, and the sigma of the
// Gaussian.
#pragma once

#include <QPainter>
#include <optional>
#include <vector>

#include "core/optics/psf.h"

namespace hogelscope {

/// Paints the weights of a window, row by row; without weights, it says so. The text below the taps
/// has the painter's colour.
void paintKernel(QPainter& painter, const QSizeF& size, const PsfParams& params,
                 const std::vector<double>& weights);
/// Returns the tap at a place of that painting, column and row from 0; none outside the window.
std::optional<QPoint> tapAt(const QPointF& place, const QSizeF& size, const QFontMetrics& text,
                            int windowSize);

}  // namespace hogelscope
