// SPDX-License-Identifier: BSD-3-Clause
// The view of an eye as a texture of the panel, for the 3-D scene.
#pragma once

#include <array>
#include <optional>

#include "core/optics/session.h"

namespace hogelscope {

/// Returns the state whose image covers the panel exactly: pixel (x, y) of `res` shows what `eye`
/// (world, metres) sees at the middle of cell (x, y) of the panel. It is a pinhole without a PSF.
/// None if the eye is not in front of the panel.
std::optional<CameraState> panelState(const DisplayParams& display, const Vec3& eye,
                                      const std::array<int, 2>& res);

/// Returns the distance from a point of the world to the nearest point of the panel, in metres.
double distanceToPanel(const DisplayParams& display, const Vec3& point);

}  // namespace hogelscope
