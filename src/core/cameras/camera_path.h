// SPDX-License-Identifier: BSD-3-Clause
// Paths of a camera: through a session's states, around its look-at, around the display.
#pragma once

#include "core/optics/session.h"

namespace hogelscope {

/// between: the states, and `count` pictures between each two of them. orbit: `count` pictures
/// around the current state's look-at, over `degrees` with the state in the middle. turntable: the
/// same around the display's vertical axis through its middle. focus: the current state's focus
/// stack (focus_stack.h) of `count` ≥ 2 pictures, the nearest first.
enum class PathKind { between, orbit, turntable, focus };
struct CameraPath {
  PathKind kind = PathKind::between;
  int count = 0;
  double degrees = 360;
};

/// Returns the states of a path's pictures, named frame_0001 and so on with as many digits as the
/// last one needs. `session` has its display's hogels and directions where the focus moves. Throws
/// InputError if there is no state, an orbiting camera has no frame, states with pictures between
/// them differ in size, the path has more than a million pictures, or as focusDistances().
std::vector<CameraState> statesAlong(const CameraPath& path, const Session& session,
                                     std::size_t current);

/// Returns the state at `position` of the path through `states`: 1 is the second state as it is,
/// 1.5 is halfway from it to the third. Eye, look-at and all other numbers change linearly, as on
/// the paths of camera sets: each picture's place is known, and between two eyes in the viewing
/// zone, which is convex, all are in it. The up direction takes the great circle, so that level
/// cameras stay level; the leakage's window is the nearest odd width.
CameraState stateAt(const std::vector<CameraState>& states, double position);

/// Returns a camera on an orbit or a turntable, `degrees` to the right of `camera`.
CameraParams turned(PathKind kind, const CameraParams& camera, const DisplayParams& display,
                    double degrees);

/// Throws InputError unless there are states and their pictures have one size.
void requireOneSize(const std::vector<CameraState>& states);

}  // namespace hogelscope
