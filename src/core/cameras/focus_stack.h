// SPDX-License-Identifier: BSD-3-Clause
// Focus stacks: images of one state at several distances of focus.
#pragma once

#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

/// Returns `count` ≥ 2 distances along the state's axis, metres, the nearest first and evenly
/// spaced in dioptres. They go from where the display is sharp in front to where it is sharp
/// behind (DesignNumbers), cut at 0.1 and 10 m. `display` has its hogels and directions. Throws
/// InputError if the state has no pupil, if its eye is not in front of the panel, or if nothing is
/// left between the cuts.
std::vector<double> focusDistances(const CameraState& state, const PanelParams& display, int count);

/// Returns the state focused at each of the distances, named NAME.focus01 and so on with as many
/// digits as the last one needs.
std::vector<CameraState> focusStack(const CameraState& state, const std::vector<double>& distances);

}  // namespace hogelscope
