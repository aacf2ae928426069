// SPDX-License-Identifier: BSD-3-Clause
// Which directional pixels a view may read.
#pragma once

#include "core/engine/fast_simulation.h"
#include "core/light_field/footprint.h"

namespace hogelscope {

/// Of pixels [x0, x1) of row y: their rays, interpolation and leakage. `view` is the simulation's.
Footprint footprint(const FastSimulation& simulation, const View& view, int y, int x0, int x1);

}  // namespace hogelscope
