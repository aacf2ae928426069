// SPDX-License-Identifier: BSD-3-Clause
// The cameras that take a display's views, for a renderer outside this program.
#pragma once

#include <string>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

/// Returns the name of a view in files, "RRR_CCC": its row v and column u, from the top left, with
/// as many digits as the largest needs, at least three.
std::string viewName(const LightFieldSize& size, int u, int v);

/// The camera of the view (u, v): a pixel of its image is a hogel, row 0 at the top. Eye and
/// look-at are metres in the display frame; its intrinsics are given.
struct RigCamera {
  int u = 0;
  int v = 0;
  CameraState state;
};

/// Returns a camera for each view, row by row. They stand on the plane z = viewingDistance, look
/// along -z, and their image planes are the panel: the axis of a camera that is not in front of the
/// panel's centre does not pass through the middle of its image (docs/formulas.md, Rig). Throws
/// InputError without a viewing distance, because the rays of a view are then parallel, and for
/// more than a million views.
std::vector<RigCamera> rigOf(const PanelParams& display);

}  // namespace hogelscope
