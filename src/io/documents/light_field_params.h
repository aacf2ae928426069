// SPDX-License-Identifier: BSD-3-Clause
// The fields of a session's light field: which ones each layout has, and what they mean.
#pragma once

#include "core/light_field/light_field.h"

namespace hogelscope {

/// Visits only the fields that the layout has, and those of raw YUV for its files alone; `content`
/// and `live` are an object of their own, named after the source.
void describe(ParameterVisitor& v, LightFieldParams& p);

/// Returns "views" and the like, as documents have it.
std::string_view nameOf(Layout layout);

}  // namespace hogelscope
