// SPDX-License-Identifier: BSD-3-Clause
// The files that a sweep's figures depend on, some of which designs alone may name.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/progress.h"
#include "core/optics/session.h"
#include "measure/sweep_table.h"

namespace hogelscope {

/// Returns the files of the session and of all its designs; those of their light fields if
/// `hasViews`. Files of a design that cannot be made are left out. Throws Cancelled.
std::vector<std::filesystem::path> filesOfDesigns(const Session& session, const SweepTable& table,
                                                  const std::vector<Design>& designs, bool hasViews,
                                                  const Progress& progress);

}  // namespace hogelscope
