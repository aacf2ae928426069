// SPDX-License-Identifier: BSD-3-Clause
// How a picture is made where less than the exact way may do: what the speed-accuracy chart
// compares, and what a tolerance chooses from.
#pragma once

namespace hogelscope {

/// How the exact mapping's rays are found.
enum class LensInverse {
  exact,       ///< certified
  newton,      ///< Method::lensSteps plain Newton steps from the distorted point
  fixedPoint,  ///< Method::lensSteps iterations, as cv::undistortPoints does it
  table        ///< exact at nodes Method::lensSteps pixels apart, bilinear between them
};

/// The default approximates nothing.
struct Method {
  LensInverse lens = LensInverse::exact;
  int lensSteps = 0;
  bool isSingle = false;      ///< float, not double, from the ray to the hogel and the direction
  double droppedTaps = 1e-3;  ///< leakage taps that change a pixel by less than this, code values
  int scale = 1;              ///< 1, 2 or 4: one pixel in scale × scale is rendered
  bool operator==(const Method&) const = default;
};

}  // namespace hogelscope
