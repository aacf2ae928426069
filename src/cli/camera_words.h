// SPDX-License-Identifier: BSD-3-Clause
// Says what files of cameras and viewers' traces have, for --info.
#pragma once

#include <ostream>
#include <string>

namespace hogelscope {

/// Whether a file has lines of time and place, as readTrace() reads them without more being said.
bool isTraceFile(const std::string& file);

/// Prints a file of cameras: its format, and of each camera its lens model, size, intrinsics and
/// place. Throws InputError.
void printCameraFile(std::ostream& out, const std::string& file);

/// Prints a trace: its lines, its duration and where the viewer was. Throws InputError.
void printTraceFile(std::ostream& out, const std::string& file);

}  // namespace hogelscope
