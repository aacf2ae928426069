// SPDX-License-Identifier: BSD-3-Clause
// One step toward a lens' inverse for many points: plain loops, compiled for several processors.
#pragma once

#include "core/optics/distortion.h"

namespace hogelscope {

/// The squared length of a short move. Newton's next step squares the error, which is then below
/// rounding.
constexpr double shortMoveSquared = 1e-18;

/// Makes a Newton step, of a fisheye in the ray's angle. `x`, `y` are the distorted points, `move`
/// receives the squared length of each step. Returns the number of points whose step is not short,
/// or is NaN.
int newtonStep(const DistortionParams& lens, const double* x, const double* y, int count,
               double* idealX, double* idealY, double* move);

/// Makes a step of cv::undistortPoints' fixed point (OpenCV 4.6), which gives up and returns the
/// distorted point where the radial factor turns negative. `isOver`, initially 0, records that. Of
/// a fisheye it is the fixed point of the ray's angle, and `isOver` receives the moves.
void fixedPointStep(const DistortionParams& lens, const double* x, const double* y, int count,
                    double* idealX, double* idealY, double* isOver);

}  // namespace hogelscope
