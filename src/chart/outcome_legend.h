// SPDX-License-Identifier: BSD-3-Clause
// Colours and texts of a lens inverse's outcomes, for all charts.
#pragma once

#include <QPainter>
#include <QString>
#include <array>

#include "study/lens_outcomes.h"

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

}  // namespace hogelscope
