// SPDX-License-Identifier: BSD-3-Clause
// --set pattern.field=value.
#pragma once

#include <string>
#include <vector>

#include "core/content/pattern.h"

namespace hogelscope {

/// Throws InputError.
PatternParams patternParams(const std::vector<std::string>& overrides);

}  // namespace hogelscope
