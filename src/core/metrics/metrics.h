// SPDX-License-Identifier: BSD-3-Clause
// How far two pictures of one state differ, on 8-bit RGB (docs/formulas.md, Metrics).
#pragma once

#include <array>

#include "core/base/parallel.h"
#include "core/optics/image.h"

namespace hogelscope {

/// Not a number where there is nothing to compare: no pixel seen in both, or a picture smaller than
/// SSIM's window.
struct Metrics {
  double mse = 0;      ///< over all pixels and channels
  double mseSeen = 0;  ///< over the pixels seen in both
  double ssim = 0;
  double seen = 0;  ///< fraction of the pixels seen in both
  /// Over all pixels of Y, Cb and Cr: BT.709, full range (all three span 255), not rounded.
  std::array<double, 3> mseYuv{};
};

/// The same numbers to the last bit for any number of threads, and on every machine with IEEE
/// arithmetic. `progress` may say stop. Throws std::invalid_argument where the sizes differ,
/// Cancelled.
Metrics compare(const Image& reference, const Image& test,
                const ParallelRows& parallelRows = serialRows, const Progress& progress = {});

/// 10 log10(255² / MSE) in dB, infinite for 0.
double psnr(double mse);

/// (6 PSNR-Y + PSNR-Cb + PSNR-Cr) / 8 in dB, as JPEG Pleno's common test conditions weigh them;
/// infinite where any of the three channels is identical.
double psnrYuv(const std::array<double, 3>& mseYuv);

/// Mean SSIM of Wang et al. 2004 on the luma (BT.601) of the pictures: 11×11 Gaussian of σ 1.5,
/// K1 0.01, K2 0.03, L = 255, over the places where the whole window lies inside. Same sizes.
double ssim(const Image& reference, const Image& test,
            const ParallelRows& parallelRows = serialRows, const Progress& progress = {});

}  // namespace hogelscope
