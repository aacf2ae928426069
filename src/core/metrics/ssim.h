// SPDX-License-Identifier: BSD-3-Clause
// Structural similarity of two images (docs/formulas.md, Metrics).
#pragma once

#include "core/base/parallel.h"
#include "core/optics/image.h"

namespace hogelscope {

struct Ssim {
  double frame = 0;  ///< over the places whose whole window lies inside the image
  double seen = 0;   ///< over those of these whose window has only pixels seen in both images
};

/// Returns the mean SSIM of Wang et al. 2004 on the luma (BT.601) of the images: 11×11 Gaussian of
/// σ 1.5, K1 0.01, K2 0.03, L = 255 in code values; NaN if there is no such place. The images have
/// one size. Throws Cancelled.
Ssim ssim(const Image& reference, const Image& test, const ParallelRows& parallelRows = serialRows,
          const Progress& progress = {});

}  // namespace hogelscope
