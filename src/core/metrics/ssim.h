// SPDX-License-Identifier: BSD-3-Clause
// Structural similarity of two images (docs/formulas.md, Metrics).
#pragma once

#include "core/base/parallel.h"
#include "core/optics/image.h"

namespace hogelscope {

/// Returns the mean SSIM of Wang et al. 2004 on the luma (BT.601) of the images: 11×11 Gaussian of
/// σ 1.5, K1 0.01, K2 0.03, L = 255, over the places where the whole window lies inside; NaN for an
/// image smaller than the window. The images have one size. Throws Cancelled.
double ssim(const Image& reference, const Image& test,
            const ParallelRows& parallelRows = serialRows, const Progress& progress = {});

}  // namespace hogelscope
