// SPDX-License-Identifier: BSD-3-Clause
// Methods to invert a lens: OpenCV's, the textbook's and this program's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

struct InverseMethod {
  std::string name;
  bool saysNoRay;  ///< NaN means "no ray"; otherwise NaN means that it has diverged
  /// Inverts a lens. Throws Cancelled.
  std::function<std::vector<Vec2>(const Distortion& lens, const std::vector<Vec2>& distorted,
                                  const Progress& progress)>
      undistort;
};

/// Returns cv::undistortPoints, a fixed-point iteration, with 5 (its default), 20 and 200
/// iterations; 20 steps of Newton's method from the distorted point; Distortion ("ours").
const std::vector<InverseMethod>& inverseMethods();

}  // namespace hogelscope
