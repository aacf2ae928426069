// SPDX-License-Identifier: BSD-3-Clause
// --tradeoff: speed against accuracy of every method on the session's own states.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Writes tradeoff.csv, tradeoff.png and tradeoff.svg. Throws InputError, Cancelled.
int tradeoff(const Options& options);

}  // namespace hogelscope
