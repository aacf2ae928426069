// SPDX-License-Identifier: BSD-3-Clause
// Stepwise moves and turns of a camera, for the keys of the Camera menu.
#pragma once

#include "core/optics/camera.h"

namespace hogelscope {

/// The motions of a camera. Walk (forward), strafe (to the right) and rise (along `up`) move both
/// eye and look-at, so that the view keeps its direction. Turn (to the right, about `up`), tilt
/// (upwards) and roll (clockwise, about the view) keep the eye; orbits (to the right about `up`,
/// and upwards) keep the look-at. All keep the distance between the two.
enum class Motion { walk, strafe, rise, turn, tilt, roll, orbitAcross, orbitUp };

/// Returns the size of a step: 0.01 m for the first three motions, 2° for the others.
double stepOf(Motion motion);

/// Moves a camera by `amount` metres or degrees; negative reverses the direction. Tilt and orbitUp
/// end one degree before the view is parallel to `up`. Throws InputError if eye, lookat and up give
/// no frame.
CameraParams moved(const CameraParams& camera, Motion motion, double amount);

}  // namespace hogelscope
