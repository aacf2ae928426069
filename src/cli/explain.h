// SPDX-License-Identifier: BSD-3-Clause
// --explain: the plan and the lens' certificate in words.
#pragma once

#include <string>

#include "core/progress.h"
#include "core/simulate.h"
#include "io/scene.h"

namespace hogelscope {

/// What is modelled for all states of a session, what is left out and why. Throws Cancelled.
std::string explanations(const Scene& scene, const Session& session, const Progress& progress);

}  // namespace hogelscope
