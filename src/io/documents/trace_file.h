// SPDX-License-Identifier: BSD-3-Clause
// Viewers' traces: CSV of time and position.
#pragma once

#include <string_view>

#include "core/cameras/camera_set.h"

namespace hogelscope {

/// Reads lines of time, x, y[, z] (seconds, rising; metres in the display frame), with or without
/// these names as a header; without z it is `distance`. Throws InputError that names the
/// line.
Trace readTrace(std::string_view text, double distance);

}  // namespace hogelscope
