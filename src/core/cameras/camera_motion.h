// SPDX-License-Identifier: BSD-3-Clause
// Moves and turns a camera by steps: what the keys of the Camera menu do.
#pragma once

#include "core/optics/camera.h"

namespace hogelscope {

/// Walk (forward), strafe (to the right) and rise (along `up`) take eye and look-at along, so that
/// the view keeps its direction. Turn (to the right, about `up`), tilt (upwards) and roll
/// (clockwise, about the view) keep the eye; orbits (to the right about `up`, and upwards) keep the
/// look-at. All keep the distance between the two.
enum class Motion { walk, strafe, rise, turn, tilt, roll, orbitAcross, orbitUp };

/// One step: 0.01 m for the first three, 2° for the others.
double stepOf(Motion motion);

/// By `amount` metres or degrees; negative is the other way. Tilt and the orbit upwards stop one
/// degree before the view is parallel to `up`. Throws InputError where eye, lookat and up give no
/// frame.
CameraParams moved(const CameraParams& camera, Motion motion, double amount);

}  // namespace hogelscope
