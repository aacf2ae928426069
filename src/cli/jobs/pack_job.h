// SPDX-License-Identifier: BSD-3-Clause
// The function that --pack and --export pack share.
#pragma once

#include "cli/command_line.h"
#include "core/optics/session.h"

namespace hogelscope {

/// Writes the session's light field as a store, and continues where an earlier run stopped. With
/// `isDisplayGiven` the store contains the session's display. Returns the exit status. Throws
/// InputError, Cancelled.
int packContent(const Session& session, bool isDisplayGiven, const CommandLine& line);

}  // namespace hogelscope
