// SPDX-License-Identifier: BSD-3-Clause
// One step toward a lens' inverse for many points: plain loops, compiled for several processors.
#pragma once

#include "core/optics/distortion.h"

namespace hogelscope {

/// Makes a Newton step. `x`, `y` are the distorted points, `move` receives the squared length of
/// each step. Returns how many of the points nearer to the centre than `certainDistorted` made a
/// step of more than 1e-9.
int newtonStep(const DistortionParams& lens, double certainDistorted, const double* x,
               const double* y, int count, double* idealX, double* idealY, double* move);

/// Makes a step of cv::undistortPoints' fixed point (OpenCV 4.6), which gives up and returns the
/// distorted point where the radial factor turns negative. `isOver`, initially 0, records that.
void fixedPointStep(const DistortionParams& lens, const double* x, const double* y, int count,
                    double* idealX, double* idealY, double* isOver);

}  // namespace hogelscope
