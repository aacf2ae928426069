// SPDX-License-Identifier: BSD-3-Clause
// Batch mode: the jobs of the command line, without a display server.
#pragma once

#include "cli/command_line.h"

namespace hogelscope {

/// Adds the folders of --plugins-path, for a job or the window. Throws InputError.
void usePluginFolders(const CommandLine& line);

/// Runs the job of the command line and returns the exit status: 0, or 1 for a failed gate. Throws
/// InputError, or Cancelled after Ctrl-C.
int runBatch(const CommandLine& line);

}  // namespace hogelscope
