// SPDX-License-Identifier: BSD-3-Clause
// Content that stands before the panel and reaches beyond it.
#pragma once

#include <string>

#include "core/optics/session.h"
#include "core/panel/display.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Returns a line on the edges of the panel at which content before it ends, as a state's eye sees
/// it: such content is cut there, since no hogel is behind it. "" where there are none, the eye is
/// not in front of the panel, or the content does not know its depths.
std::string cutWarning(const plugin::ContentSource& content, const DisplayParams& display,
                       const CameraState& state);

}  // namespace hogelscope
