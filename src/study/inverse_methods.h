// SPDX-License-Identifier: BSD-3-Clause
// Ways to invert a lens: OpenCV's, the textbook's and ours.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

struct InverseMethod {
  std::string name;
  bool saysNoRay;  ///< what is not a number is its word for "no ray"; else it has diverged
  /// `progress` may say stop; then it throws Cancelled.
  std::function<std::vector<Vec2>(const Distortion& lens, const std::vector<Vec2>& distorted,
                                  const Progress& progress)>
      undistort;
};

/// cv::undistortPoints, a fixed-point iteration, with 5 (its default), 20 and 200 iterations;
/// 20 steps of Newton's method from the distorted point; ours.
const std::vector<InverseMethod>& inverseMethods();

}  // namespace hogelscope
