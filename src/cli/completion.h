// SPDX-License-Identifier: BSD-3-Clause
// Bash completion, generated from the tables of jobs and flags.
#pragma once

#include <string>

namespace hogelscope {

/// Returns a bash script, which --help completion prints and the build installs.
std::string bashCompletion();

}  // namespace hogelscope
