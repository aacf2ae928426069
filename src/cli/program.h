// SPDX-License-Identifier: BSD-3-Clause
// The common start of both programs, batch mode and the window; and batch mode, which runs a job
// without a display server.
#pragma once

#include <functional>

#include "cli/command_line.h"

namespace hogelscope {

/// Parses the command line and calls `run`, whose exit status it returns. The only place where
/// errors become a line and an exit status.
int runProgram(int argc, char** argv, const std::function<int(const CommandLine&)>& run);

/// Adds the folders of --plugins-path, for a job or the window. Throws InputError.
void usePluginFolders(const CommandLine& line);

/// Runs the job of the command line and returns the exit status: 0, or 1 for a failed gate. Throws
/// InputError, or Cancelled after Ctrl-C.
int runBatch(const CommandLine& line);

}  // namespace hogelscope
