// SPDX-License-Identifier: BSD-3-Clause
// --explain: the plan and the lens' certificate in words.
#pragma once

#include <string>

#include "core/simulate.h"
#include "io/light_field_file.h"

namespace hogelscope {

/// What is modelled for a view, what is left out and why.
std::string explanation(const View& view);

/// Of all states of a session.
std::string explanations(const Scene& scene, const Session& session);

}  // namespace hogelscope
