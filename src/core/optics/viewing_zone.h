// SPDX-License-Identifier: BSD-3-Clause
// The display's viewing zone: the points that its light reaches.
#pragma once

#include "core/optics/display.h"

namespace hogelscope {

/// Returns the share of the panel's area, 0 … 1, that sends light to a point of the world (metres):
/// 1 if all of the panel can be seen from there, 0 if the point is outside the viewing zone.
double shareSeenFrom(const DisplayParams& display, const Vec3& point);

}  // namespace hogelscope
