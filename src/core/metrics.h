// SPDX-License-Identifier: BSD-3-Clause
// How far two pictures of one state differ (DESIGN §2 "Metrics"), on 8-bit RGB.
#pragma once

#include "core/image.h"

namespace hogelscope {

/// Not a number where there is nothing to compare: no pixel seen in both, or a picture smaller than
/// SSIM's window.
struct Metrics {
  double mse = 0;      ///< over all pixels and channels
  double mseSeen = 0;  ///< over the pixels seen in both
  double ssim = 0;
  double seen = 0;  ///< fraction of the pixels seen in both
};

/// Throws std::invalid_argument where the sizes differ.
Metrics compare(const Image& reference, const Image& test);

/// 10 log10(255² / MSE) in dB, infinite for 0.
double psnr(double mse);

/// Mean SSIM of Wang et al. 2004 on the luma (BT.601) of the pictures: 11×11 Gaussian of σ 1.5,
/// K1 0.01, K2 0.03, L = 255, over the places where the whole window lies inside. Same sizes.
double ssim(const Image& reference, const Image& test);

}  // namespace hogelscope
