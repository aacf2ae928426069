// SPDX-License-Identifier: BSD-3-Clause
// Parsing of the command line by the tables of jobs and flags.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.h"

namespace hogelscope {

/// Parses the arguments. Throws InputError for an unknown option (with the nearest known one), one
/// that the job does not use, one given twice, a missing or an invalid value.
CommandLine parseCommandLine(const std::vector<std::string>& arguments);

}  // namespace hogelscope
