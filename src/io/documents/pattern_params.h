// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a pattern from overrides of the form pattern.field=value.
#pragma once

#include <string>
#include <vector>

#include "core/content/pattern.h"

namespace hogelscope {

/// Returns the defaults with the overrides applied. Throws InputError.
PatternParams patternParams(const std::vector<std::string>& overrides);

}  // namespace hogelscope
