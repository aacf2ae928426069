// SPDX-License-Identifier: BSD-3-Clause
// A display for a mesh.
#pragma once

#include "core/base/progress.h"
#include "core/light_field/light_field.h"
#include "core/panel/display.h"

namespace hogelscope {

/// Makes a mesh fill nine tenths of a panel that has its shape, seen from the front, and a longer
/// side of 0.5 m, or less of it, so that the eye in front of the display (inFrontOf()) sees all of
/// the mesh within the panel's edges. A quarter of its depth, but not more than a tenth of that
/// side, stands before the panel. Sets the content's place and scale, and the display's size,
/// hogels, directions and field. Reads the mesh. Throws InputError, Cancelled.
void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress);

}  // namespace hogelscope
