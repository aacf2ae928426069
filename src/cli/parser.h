// SPDX-License-Identifier: BSD-3-Clause
// From words to a command line that the tables of jobs and flags allow.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.h"

namespace hogelscope {

/// Throws InputError: an unknown option (with the nearest one), one that the job does not use, one
/// given twice, a missing or a wrong value.
CommandLine parseCommandLine(const std::vector<std::string>& arguments);

}  // namespace hogelscope
