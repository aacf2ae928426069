// SPDX-License-Identifier: BSD-3-Clause
// Which field of a camera state or a session an edit changes, for the name of what can be taken
// back.
#pragma once

#include <string>

#include "core/optics/session.h"

namespace hogelscope {

/// The name of the first one; "" if none.
std::string changedField(const CameraState& before, const CameraState& after);
/// The same of display, light field and sampling.
std::string changedField(const Session& before, const Session& after);

}  // namespace hogelscope
