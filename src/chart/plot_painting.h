// SPDX-License-Identifier: BSD-3-Clause
// Paints a plot of the report's page in the window.
#pragma once

#include <QPainter>
#include <QPointF>
#include <optional>

#include "page/plot.h"

namespace hogelscope {

/// Paints at any size from about 250×150 points, with a ring around the points of `selected`.
void paintPlot(QPainter& painter, const QSizeF& size, const Plot& plot,
               std::optional<std::size_t> selected = {});
/// Returns the row of the nearest point, if it is within a few points of `place`.
std::optional<std::size_t> rowAt(const Plot& plot, const QPointF& place, const QSizeF& size);
/// Returns the place of a row's point; none if it has none.
std::optional<QPointF> placeOf(const Plot& plot, std::size_t row, const QSizeF& size);

}  // namespace hogelscope
