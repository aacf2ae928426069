// SPDX-License-Identifier: BSD-3-Clause
// The display in JSON documents, whose lens may be a plugin's.
#pragma once

#include "core/panel/display.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

/// Returns the parameters of a plugin's lens, at their defaults. Throws InputError if there is no
/// such plugin or it cannot be used.
LensParams lensParamsOf(const std::string& source);

/// Returns an edited display with the parameters of its plugin's lens, those of a new plugin at
/// their defaults. Throws InputError if there is no such plugin or its lens cannot be opened.
DisplayParams withLensParams(const DisplayParams& before, DisplayParams after);

/// Reads the object `calibration` of a display: the figures, `serial`, `cells` and `pattern`.
/// Throws InputError with `path`.
SheetCalibration readSheet(const Json& object, const std::string& path);
Json writtenSheet(const SheetCalibration& calibration);

/// Reads the object `display`. Throws InputError with the path of the field.
DisplayParams readDisplay(const Json& object);

Json writtenDisplay(const DisplayParams& params);

}  // namespace hogelscope
