// SPDX-License-Identifier: BSD-3-Clause
// Reads viewers' traces: CSV of time and position.
#pragma once

#include <string_view>

#include "core/cameras/camera_set.h"

namespace hogelscope {

/// Reads a table whose first line names the columns, in any order and among others, or without
/// names lines of time, x, y[, z]. An eye is at scale · (value − origin) in the display frame;
/// `distance` replaces a missing z. Throws InputError that names the line.
Trace readTrace(std::string_view text, double distance, const TraceParams& params = {});

}  // namespace hogelscope
