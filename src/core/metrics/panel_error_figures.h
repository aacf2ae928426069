// SPDX-License-Identifier: BSD-3-Clause
// Summary figures of the error on the panel: planes for files, false-colour images, text.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/metrics/panel_error.h"
#include "core/optics/image.h"
#include "core/panel/display.h"

namespace hogelscope {

/// Figures of the panel error. The "costliest" cell holds most of the squared error of all views.
struct PanelErrorFigures {
  double hogelScale = 0;      ///< MSE at the end of the colour scale, see `scaleEnd`
  double directionScale = 0;  ///< the same for directions
  /// The least share of the non-empty cells that holds half of the squared error; 0 without error.
  double hogelShare = 0;
  double directionShare = 0;
  std::array<int, 2> hogel{};  ///< i, j of the costliest hogel
  Vec2 direction;  ///< the costliest one, in degrees to the right and up as the light leaves
};

PanelErrorFigures figuresOf(const PanelError& error, const PanelParams& display);

/// Returns one sentence.
std::string panelErrorText(const PanelErrorFigures& figures);

/// Returns a cell's mean squared error per channel, in code values: squares / (3·pixels·perCode²).
/// NaN without pixels.
double meanSquare(const PanelError::Cell& cell, int perCode = 1);
std::vector<float> meanSquares(const std::vector<PanelError::Cell>& cells, int perCode = 1);
/// Returns the number of pixels of each cell.
std::vector<float> pixelCounts(const std::vector<PanelError::Cell>& cells);

/// Returns the 99th percentile of the cells' mean squared errors, so that one outlier does not hide
/// the rest; the largest one if that is 0.
double scaleEnd(const std::vector<PanelError::Cell>& cells, int perCode = 1);
/// Returns the same for mean squared errors, without those that are NaN.
double scaleEndOf(std::vector<double> means);

/// Returns false colours of the mean squared errors from 0 to the figures' scales, grey without
/// pixels. Each cell is a block of pixels, so that the longer side of a small panel has at least
/// 256, in the shape of the panel or of the angular field.
Image hogelErrorImage(const PanelError& error, const PanelParams& display);
Image directionErrorImage(const PanelError& error, const PanelParams& display);
/// Returns the same blocks for colours given as shares 0 … 1 of each direction; grey for NaN.
Image directionImage(const std::vector<double>& shares, const PanelParams& display);

}  // namespace hogelscope
