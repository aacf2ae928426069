// SPDX-License-Identifier: BSD-3-Clause
// --stability: where methods fail, as a table and as maps.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Writes stability.csv and stability.png. Throws InputError, Cancelled.
int stabilityJob(const Options& options);

}  // namespace hogelscope
