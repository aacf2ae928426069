// SPDX-License-Identifier: BSD-3-Clause
// --info: what a file is.
#pragma once

#include "cli/options.h"

namespace hogelscope {

/// Prints what a session, a picture, a folder of views or a store is, read as --set says. Throws
/// InputError.
int infoJob(const Options& options);

}  // namespace hogelscope
