// SPDX-License-Identifier: BSD-3-Clause
// What the jobs of the command line begin with.
#pragma once

#include "cli/options.h"
#include "core/session.h"

namespace hogelscope {

/// The session with --calibration, --set and only the --states asked for; warnings go to stderr.
/// Throws InputError.
Session loadSelected(const Options& options);

}  // namespace hogelscope
