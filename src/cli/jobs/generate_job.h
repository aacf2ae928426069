// SPDX-License-Identifier: BSD-3-Clause
// --generate: a test light field of any size.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Writes it row of hogels by row; two of those are in memory. Throws InputError, Cancelled.
int generateJob(const Options& options);

}  // namespace hogelscope
