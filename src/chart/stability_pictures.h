// SPDX-License-Identifier: BSD-3-Clause
// The stability map of the lens inverses, pictures of single lenses, and the colours and texts of
// the outcomes.
#pragma once

#include <QPainter>
#include <QString>
#include <array>

#include "chart/painting.h"
#include "study/lens_maps.h"
#include "study/lens_outcomes.h"
#include "study/stability.h"

namespace hogelscope {

/// Returns a colour, light for right outcomes and dark for wrong ones, distinct for colour-blind
/// readers and in greyscale.
QRgb colourOf(Outcome outcome);

using OutcomeWords = std::array<QString, outcomeCount>;

/// Returns the place of a line of the legend, which has two columns of three lines and is 66 points
/// high.
QRectF legendLine(const QRectF& area, int index);
/// Paints a sample and a text for each outcome, in their order.
void paintOutcomeLegend(QPainter& painter, const QRectF& area, const OutcomeWords& words);

/// Paints bold text in the middle of the area.
void paintTitle(QPainter& painter, const QRectF& area, const QString& title);

QString titleOf(const InverseMethod& method);

/// Paints one row of maps for each plane, one column for each method, and a legend below.
void paintStabilityMaps(QPainter& painter, const QSizeF& size, const std::vector<LensMap>& maps);

/// Returns the size in points for which the maps are designed.
QSize stabilityMapsSize();

/// The largest number of lenses in one image; later ones are only in the table.
constexpr std::size_t mostLensPictures = 24;

/// Paints the outcome of every measured pixel: one row for each lens starting at `first`, one
/// column for each method, and a legend below.
void paintLensPictures(QPainter& painter, const QSizeF& size, const Stability& stability,
                       std::size_t first);

/// Returns the size in points for which the maps are designed.
QSize lensPicturesSize(const Stability& stability, std::size_t first);

}  // namespace hogelscope
