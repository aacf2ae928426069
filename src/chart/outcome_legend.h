// SPDX-License-Identifier: BSD-3-Clause
// The colours and words of a lens inverse's outcomes, in all charts of them.
#pragma once

#include <QPainter>
#include <QString>
#include <array>

#include "study/lens_outcomes.h"

namespace hogelscope {

/// Returns a light colour where all is well, a dark one where it is not; told apart by the
/// colour-blind and in grey.
QRgb colourOf(Outcome outcome);

using OutcomeWords = std::array<QString, outcomeCount>;

/// The place of a line of the legend, which has two columns of three lines, 66 points high.
QRectF legendLine(const QRectF& area, int index);
/// Paints a sample and words for each outcome, in their order.
void paintOutcomeLegend(QPainter& painter, const QRectF& area, const OutcomeWords& words);

/// Paints bold text in the middle of the area.
void paintTitle(QPainter& painter, const QRectF& area, const QString& title);

QString titleOf(const InverseMethod& method);

}  // namespace hogelscope
