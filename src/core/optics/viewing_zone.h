// SPDX-License-Identifier: BSD-3-Clause
// The display's viewing zone: the places that its light reaches.
#pragma once

#include "core/optics/display.h"

namespace hogelscope {

/// Which share of the panel's area, 0 … 1, sends light to a point of the world (metres): 1 all of
/// the panel can be seen from there, 0 the point is outside the viewing zone.
double shareSeenFrom(const DisplayParams& display, const Vec3& point);

}  // namespace hogelscope
