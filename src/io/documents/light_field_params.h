// SPDX-License-Identifier: BSD-3-Clause
// The fields of a session's light field, with their meanings, for each layout; the parameters of a
// pattern from overrides of the form pattern.field=value.
#pragma once

#include <string>
#include <vector>

#include "core/content/pattern.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// Visits only the fields that the layout has, and those of raw YUV only for such files. `content`
/// and `live` are not visited: documents have them in an object of their own, named after the
/// source.
void describe(ParameterVisitor& v, LightFieldParams& p);

/// Returns the layout's name in documents, such as "views".
std::string_view nameOf(Layout layout);

/// Returns the defaults with the overrides applied. Throws InputError.
PatternParams patternParams(const std::vector<std::string>& overrides);

}  // namespace hogelscope
