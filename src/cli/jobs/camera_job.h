// SPDX-License-Identifier: BSD-3-Clause
// --make-cameras: a set of camera states, added to a copy of a session.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Writes the session to --output, which may be the session itself. Throws InputError.
int makeCameras(const Options& options);

}  // namespace hogelscope
