// SPDX-License-Identifier: BSD-3-Clause
// What the error on the panel amounts to: planes for files, false-colour images, words.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/metrics/panel_error.h"
#include "core/optics/display.h"
#include "core/optics/image.h"

namespace hogelscope {

/// "Costliest" is what holds most of the squared error, summed over all views.
struct PanelErrorFigures {
  double hogelScale = 0;      ///< MSE at the end of the image's colours, see `scaleEnd`
  double directionScale = 0;  ///< likewise
  /// How few of the cells that pixels fell on hold half of the squared error; 0 where there is
  /// none.
  double hogelShare = 0;
  double directionShare = 0;
  std::array<int, 2> hogel{};  ///< i, j of the costliest
  Vec2 direction;              ///< the costliest: degrees to the right and up, as the light leaves
};

PanelErrorFigures figuresOf(const PanelError& error, const DisplayParams& display);

/// One sentence.
std::string panelErrorText(const PanelErrorFigures& figures);

/// Mean squared error of a cell in code values, per channel: squares / (3·pixels·perCode²). NaN
/// where no pixel fell.
double meanSquare(const PanelError::Cell& cell, int perCode = 1);
std::vector<float> meanSquares(const std::vector<PanelError::Cell>& cells, int perCode = 1);
/// Pixels of each cell.
std::vector<float> pixelCounts(const std::vector<PanelError::Cell>& cells);

/// The 99th percentile of the cells' mean squared errors, so that one outlier does not hide the
/// rest; the largest where that is 0.
double scaleEnd(const std::vector<PanelError::Cell>& cells, int perCode = 1);
/// The same of mean squared errors, those that are NaN left out.
double scaleEndOf(std::vector<double> means);

/// False colours of the mean squared errors from 0 to the figures' scales, grey where no pixel
/// fell. Each cell is a block of pixels, so that small panels are 256 or more along their longer
/// side, in the shape of the panel or of the angular field.
Image hogelErrorImage(const PanelError& error, const DisplayParams& display);
Image directionErrorImage(const PanelError& error, const DisplayParams& display);
/// The same blocks for a share of the colours, 0 … 1, of each direction; grey where it is NaN.
Image directionImage(const std::vector<double>& shares, const DisplayParams& display);

}  // namespace hogelscope
