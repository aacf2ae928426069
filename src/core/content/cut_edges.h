// SPDX-License-Identifier: BSD-3-Clause
// The warning about content in front of the panel that reaches beyond its edges.
#pragma once

#include <string>

#include "core/optics/session.h"
#include "core/panel/display.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Returns a line that names the edges of the panel at which a state's eye sees content in front of
/// it cut, since no hogel is behind it there. Returns "" if there are none, the eye is not in front
/// of the panel, or the content does not know its depths.
std::string cutWarning(const plugin::ContentSource& content, const PanelParams& display,
                       const CameraState& state);

}  // namespace hogelscope
