// SPDX-License-Identifier: BSD-3-Clause
// The completion of command lines in bash, made from the tables of jobs and flags.
#pragma once

#include <string>

namespace hogelscope {

/// A script for bash: what --help completion prints and the build installs.
std::string bashCompletion();

}  // namespace hogelscope
