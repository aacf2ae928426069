// SPDX-License-Identifier: BSD-3-Clause
// --report: every state from the session's light field and from each test, compared.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Exit status: 0, or 1 for a failed gate. Throws InputError, or Cancelled.
int reportJob(const Options& options);

}  // namespace hogelscope
