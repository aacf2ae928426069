// SPDX-License-Identifier: BSD-3-Clause
// The paper's validation of its lens: a distorted view, undistorted by OpenCV's formula, against
// the view without the lens.
#pragma once

#include "core/metrics/error_map.h"
#include "core/optics/session.h"
#include "study/instabilities.h"

namespace hogelscope {

/// Returns the distorted view of a state as cv::undistort straightens it with the state's
/// intrinsics and lens: bilinear between pixels, seen where all of these are seen. Beyond a fold of
/// the lens it shows other places of the view, as OpenCV does.
Image undistortedByOpenCv(const Image& distorted, const CameraState& state);

/// A straightened view against the view without the lens, over the pixels that both see.
struct Undistortion {
  Image openCvs;
  DifferenceImage difference;  ///< black where a pixel is not seen in both
  double psnr = 0;             ///< dB, over the pixels seen in both; infinite if they are equal
  std::size_t points = 0;      ///< pixels seen in both
};

/// `undistorted` is the view of `state` without distortion.
Undistortion compareUndistortion(const Image& distorted, const Image& undistorted,
                                 const CameraState& state);

/// Measures `psnr` for the lens of the paper's Fig. 3 with its coefficients times x, with both
/// mappings (`exact`, `direct`), of a smooth content: kind undistortion of stability.csv. Throws
/// Cancelled.
std::vector<InstabilityRow> undistortionErrors(const ParallelRows& parallelRows,
                                               const Progress& progress);

}  // namespace hogelscope
