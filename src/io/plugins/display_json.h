// SPDX-License-Identifier: BSD-3-Clause
// The parts of a display in documents, whose lens may be a plugin's.
#pragma once

#include "core/panel/display.h"
#include "io/json/sections.h"

namespace hogelscope {

/// Returns the parameters of a plugin's lens, at their defaults. Throws InputError if there is no
/// such plugin or it cannot be used.
LensParams lensParamsOf(const std::string& source);

/// Returns an edited display with the parameters of its plugin's lens, those of a new plugin at
/// their defaults. Throws InputError if there is no such plugin or its lens cannot be opened.
DisplayParams withLensParams(const DisplayParams& before, DisplayParams after);

/// Visits a calibration: its figures, `serial`, `cells` and `pattern`.
void describeParts(SectionVisitor& v, SheetCalibration& calibration);
/// Visits a display of any kind, its calibration, and its lens's parameters, which a plugin has.
void describeParts(SectionVisitor& v, DisplayParams& params);

}  // namespace hogelscope
