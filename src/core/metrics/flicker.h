// SPDX-License-Identifier: BSD-3-Clause
// The error of a view's change from one frame to the next, which the eye sees as flicker
// (docs/formulas.md, Frames).
#pragma once

#include <cstdint>
#include <vector>

#include "core/metrics/metric.h"

namespace hogelscope {

/// The difference of a test's view from the reference's at one frame.
struct FrameDifference {
  std::vector<float> values;       ///< test - reference, code values, 3·width·height
  std::vector<std::uint8_t> seen;  ///< not 0 where both see the display, width·height
};

/// Throws std::invalid_argument if the sizes differ.
FrameDifference frameDifference(const Image& reference, const Image& test);

/// Means of (T_k - T_{k-1} - R_k + R_{k-1})², in code values; NaN over no pixel.
struct FlickerError {
  double mse = 0;      ///< over all pixels and channels
  double mseSeen = 0;  ///< over the pixels that see the display in all four images
};

/// Throws std::invalid_argument if the sizes differ.
FlickerError flickerError(const FrameDifference& before, const FrameDifference& after);

/// Returns the columns flicker_mse and flicker_mse_seen with the PSNRs of their means. It is no
/// metric of two pictures: its values are NaN, and flickerValues() gives those of a row.
Metric flickerMetric();
std::vector<double> flickerValues(const FlickerError& error);

}  // namespace hogelscope
