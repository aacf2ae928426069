// SPDX-License-Identifier: BSD-3-Clause
// Which field of a camera state an edit changes, for the name of what can be taken back.
#pragma once

#include <string>

#include "core/session.h"

namespace hogelscope {

/// The name of the first one; "" if none.
std::string changedField(const CameraState& before, const CameraState& after);

}  // namespace hogelscope
