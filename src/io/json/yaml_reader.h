// SPDX-License-Identifier: BSD-3-Clause
// Reads YAML as cv::FileStorage writes it, from untrusted files.
#pragma once

#include <string>

#include "io/json/json_parameters.h"

namespace hogelscope {

/// Returns the names and values of all documents in the file, as one object. A plain scalar that is
/// a finite number becomes a number, every other scalar a text (also .Inf and .Nan); tags are
/// ignored. Throws InputError that names the line: not YAML, an alias, a duplicate name, nesting
/// deeper than in any calibration.
Json parseOpenCvYaml(const std::string& text);

}  // namespace hogelscope
