// SPDX-License-Identifier: BSD-3-Clause
// Batch mode: the jobs of the command line, without a display server.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Does what the options ask for and gives the exit status: 0, or 1 for a failed gate. Throws
/// InputError, or Cancelled after Ctrl-C.
int runBatch(const Options& options);

/// --render. Throws InputError, or Cancelled.
int render(const Options& options);

}  // namespace hogelscope
