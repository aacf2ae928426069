// SPDX-License-Identifier: BSD-3-Clause
// The common start of both programs, batch mode and the window.
#pragma once

#include <functional>

#include "cli/command_line.h"

namespace hogelscope {

/// Parses the command line and calls `run`, whose exit status it returns. The only place where
/// errors become a line and an exit status.
int runProgram(int argc, char** argv, const std::function<int(const CommandLine&)>& run);

}  // namespace hogelscope
