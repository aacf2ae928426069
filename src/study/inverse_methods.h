// SPDX-License-Identifier: BSD-3-Clause
// Methods of inverting a lens: OpenCV's, the textbook's and this program's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

struct InverseMethod {
  std::string name;
  bool saysNoRay;  ///< whether NaN means "no ray"; otherwise NaN means divergence
  /// Inverts a lens. Throws Cancelled.
  std::function<std::vector<Vec2>(const Distortion& lens, const std::vector<Vec2>& distorted,
                                  const Progress& progress)>
      undistort;
};

/// Returns the methods: cv::undistortPoints, a fixed-point iteration, with 5 (its default), 20 and
/// 200 iterations; 20 Newton steps from the distorted point; Distortion ("ours").
const std::vector<InverseMethod>& inverseMethods();

}  // namespace hogelscope
