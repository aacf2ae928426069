// SPDX-License-Identifier: BSD-3-Clause
// Paints a plot of a report in the window and for its file.
#pragma once

#include <QPainter>
#include <QPointF>
#include <optional>

#include "chart/painting.h"
#include "page/plot.h"

namespace hogelscope {

/// Paints at any size from about 250×120 pixels in the painter's font, with a ring around the point
/// of `selected` and its name.
void paintPlot(QPainter& painter, const QSizeF& size, const Plot& plot, const ChartColours& colours,
               std::optional<std::size_t> selected = {});
/// Paints a series' mark in the painter's brush and pen.
void paintMark(QPainter& painter, const QPointF& at, double radius, std::size_t series);
/// Paints an upright bar of the false colours with the values of its ends, top left at `at`.
void paintColourBar(QPainter& painter, const QRectF& bar, const QString& low, const QString& high,
                    const QColor& text);
/// Returns the row of the nearest point, if it is within a few pixels of `place`. `text` is the
/// font's size in pixels.
std::optional<std::size_t> rowAt(const Plot& plot, const QPointF& place, const QSizeF& size,
                                 double text = 12);
/// Returns the place of a row's point; none if it has none.
std::optional<QPointF> placeOf(const Plot& plot, std::size_t row, const QSizeF& size,
                               double text = 12);

}  // namespace hogelscope
