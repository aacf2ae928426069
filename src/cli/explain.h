// SPDX-License-Identifier: BSD-3-Clause
// --explain: the plan and the lens' certificate as text.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "io/scene/view_source.h"

namespace hogelscope {

/// Returns, for all states of a session, what is modelled, what is omitted and why. Throws
/// Cancelled.
std::string explanations(const ViewSource& source, const Session& session,
                         const Progress& progress);

}  // namespace hogelscope
