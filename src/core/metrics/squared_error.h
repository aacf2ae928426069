// SPDX-License-Identifier: BSD-3-Clause
// MSE and PSNR of two images (docs/formulas.md, Metrics).
#pragma once

#include <array>

#include "core/base/progress.h"
#include "core/optics/image.h"

namespace hogelscope {

/// Means of squared differences of code values, 0 … 255 for any bit depth; NaN over no pixel.
struct SquaredError {
  double mse = 0;      ///< over all pixels and channels
  double mseSeen = 0;  ///< over the pixels that see the display in both images
  double seen = 0;     ///< the fraction of these pixels
  /// The MSE of Y, Cb and Cr: BT.709, full range (all three span 255), not rounded.
  std::array<double, 3> mseYuv{};
  std::array<double, 3> mseYuvSeen{};
};

/// Computes the errors of images of one size. Throws Cancelled.
SquaredError squaredError(const Image& reference, const Image& test, const Progress& progress = {});

/// Returns 10 log10(255² / MSE) in dB, infinite for 0.
double psnr(double mse);

/// Returns (6 PSNR-Y + PSNR-Cb + PSNR-Cr) / 8 in dB, the weights of JPEG Pleno's common test
/// conditions; infinite if any of the three channels is identical.
double psnrYuv(const std::array<double, 3>& mseYuv);

}  // namespace hogelscope
