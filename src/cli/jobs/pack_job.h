// SPDX-License-Identifier: BSD-3-Clause
// --pack: a light field becomes a store.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Goes on where an earlier run stopped. Throws InputError, Cancelled.
int packJob(const Options& options);

}  // namespace hogelscope
