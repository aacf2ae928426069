// SPDX-License-Identifier: BSD-3-Clause
// Histograms of images, drawn over each other.
#pragma once

#include <QPainter>
#include <QStringList>
#include <vector>

#include "chart/painting.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

/// Paints up to four histograms in the painter's font: the first is filled, the others are lines.
/// Heights are square roots of counts. A line above them has their `names`, means and the values of
/// the darkest and brightest hundredth; `colours.text` is that of this line, `colours.text2` of the
/// axis.
void paintHistograms(QPainter& painter, const QSize& size, const std::vector<Histogram>& histograms,
                     const QStringList& names, const ChartColours& colours);

}  // namespace hogelscope
