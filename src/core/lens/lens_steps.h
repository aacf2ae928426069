// SPDX-License-Identifier: BSD-3-Clause
// One step towards a lens' inverse for many points: plain loops, compiled for each kind of machine.
#pragma once

#include "core/optics/distortion.h"

namespace hogelscope {

/// Newton's. `x`, `y` are the distorted points, `move` gets the squared length of each step.
/// Returns how many of the points nearer to the centre than `certainDistorted` made a step of
/// more than 1e-9.
int newtonStep(const DistortionParams& lens, double certainDistorted, const double* x,
               const double* y, int count, double* idealX, double* idealY, double* move);

/// cv::undistortPoints' fixed point (OpenCV 4.6): where the radial factor turns negative it gives
/// up and returns the distorted point. `isOver` begins with 0 and remembers that.
void fixedPointStep(const DistortionParams& lens, const double* x, const double* y, int count,
                    double* idealX, double* idealY, double* isOver);

}  // namespace hogelscope
