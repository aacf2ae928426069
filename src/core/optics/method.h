// SPDX-License-Identifier: BSD-3-Clause
// Approximate rendering methods, which the speed-accuracy chart compares, and from which a
// tolerance chooses.
#pragma once

#include "core/optics/aperture.h"

namespace hogelscope {

/// The inverse of the lens that finds the rays of the exact mapping.
enum class LensInverse {
  exact,       ///< certified
  newton,      ///< Method::lensSteps plain Newton steps from the distorted point
  fixedPoint,  ///< Method::lensSteps iterations of cv::undistortPoints' kind
  table        ///< exact at nodes Method::lensSteps pixels apart, bilinear between them
};

/// A rendering method. The default approximates nothing.
struct Method {
  LensInverse lens = LensInverse::exact;
  int lensSteps = 0;
  bool isSingle = false;      ///< float instead of double, from the ray to hogel and direction
  double droppedTaps = 1e-3;  ///< drops leakage taps that change a pixel by less, code values
  int scale = 1;              ///< 1, 2 or 4: one pixel in scale × scale is rendered
  AperturePattern aperture = AperturePattern::vogel;  ///< the points of the pupil
  bool operator==(const Method&) const = default;
};

}  // namespace hogelscope
