// SPDX-License-Identifier: BSD-3-Clause
// The panel as an eye sees it, laid out on the panel itself: what the 3-D scene puts onto it.
#pragma once

#include <array>
#include <optional>

#include "core/optics/session.h"

namespace hogelscope {

/// The state whose picture covers the panel exactly: pixel (x, y) of `res` shows what `eye` (world,
/// metres) sees at the middle of cell (x, y) of the panel. Its lens is a pinhole, its PSF none.
/// None where the eye is not in front of the panel.
std::optional<CameraState> panelState(const DisplayParams& display, const Vec3& eye,
                                      const std::array<int, 2>& res);

/// From a point of the world to the nearest one of the panel, in metres.
double distanceToPanel(const DisplayParams& display, const Vec3& point);

}  // namespace hogelscope
