// SPDX-License-Identifier: BSD-3-Clause
// Reads viewers' traces: tables of time and position.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/cameras/camera_set.h"

namespace hogelscope {

/// Reads a table whose first line names the columns, in any order and among others, or without
/// names lines of time, x, y[, z], also with a quaternion behind, as TUM and EuRoC have it. Cells
/// are separated by semicolons, tabs, commas or spaces, or by what a first line "sep=;" says; lines
/// that begin with # are comments, unless they name the columns. Unless `params` names the columns,
/// usual names of them and their units are found ("timestamp [ns]"). An eye is at scale · (value −
/// origin) in the display frame; `distance` replaces a missing z. Adds what is guessed, and what is
/// left aside, to `notes`. Throws InputError that names the line.
Trace readTrace(std::string_view text, double distance, const TraceParams& params = {},
                std::vector<std::string>* notes = nullptr);

}  // namespace hogelscope
