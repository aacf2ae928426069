// SPDX-License-Identifier: BSD-3-Clause
// The states of a light field in time: each at each frame, or at the frame of its own time.
#pragma once

#include <string>
#include <vector>

#include "core/light_field/frames.h"
#include "core/optics/session.h"

namespace hogelscope {

struct FrameState {
  CameraState state;
  int frame = 0;
};

/// Returns the states in the order frame, state: those without a time at each of the frames
/// `wanted`, the others at the frame of `listed` that is shown at their time, if `rate` frames of
/// the source are shown in a second. Throws InputError for a time if the rate is not known (0).
std::vector<FrameState> statesAtFrames(const std::vector<CameraState>& states,
                                       const FrameNumbers& wanted, const FrameNumbers& listed,
                                       double rate);

/// Returns the digits of a frame in names of files: four, or as many as the last one needs.
std::string frameDigits(int frame, const FrameNumbers& listed);

/// Returns the frames of "all", "7", "0:99" (both ends) or "0:99:10", each of which is listed.
/// Throws InputError that begins with `name` and says what is listed.
FrameNumbers framesFrom(const std::string& name, const std::string& text,
                        const FrameNumbers& listed);

}  // namespace hogelscope
