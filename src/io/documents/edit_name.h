// SPDX-License-Identifier: BSD-3-Clause
// Finds the field of a camera state or a session that an edit changes; the undo menu names the edit
// after it.
#pragma once

#include <string>

#include "core/optics/session.h"

namespace hogelscope {

/// Returns the name of the first changed field; "" if none.
std::string changedField(const CameraState& before, const CameraState& after);
/// Returns the same for display, light field and sampling.
std::string changedField(const Session& before, const Session& after);

}  // namespace hogelscope
