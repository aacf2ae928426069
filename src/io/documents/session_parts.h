// SPDX-License-Identifier: BSD-3-Clause
// The one description of a session's document. A new section is a line here.
#pragma once

#include "core/optics/session.h"
#include "io/json/sections.h"
#include "io/plugins/display_json.h"

namespace hogelscope {

/// Visits `rows`, `columns` and `hogels`, each a list.
void describeParts(SectionVisitor& v, DeadParts& dead);

void describeParts(SectionVisitor& v, Session& session);

}  // namespace hogelscope
